//! Finds and extracts the changed area of a frame.

use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::primitives::Rectangle;

/// Returns the smallest rectangle that contains all pixels that differ between two frames. If no
/// pixel differs, the rectangle has one pixel. A pixel has `N` bytes, and pixels are stored row by
/// row.
pub(super) fn changed_area<const N: usize>(
    previous: &[u8],
    current: &[u8],
    width: u32,
) -> Rectangle {
    let ((previous, _), (current, _)) = (previous.as_chunks::<N>(), current.as_chunks::<N>());
    let pairs = previous.iter().zip(current).zip(0_i32..);
    let changed = pairs.filter(|((old, new), _)| old != new);
    let points = changed.map(|(_, index)| Point::new(index % width as i32, index / width as i32));
    let corners = points.fold(None, |corners: Option<[Point; 2]>, point| {
        let [min, max] = corners.unwrap_or([point, point]);
        Some([min.component_min(point), max.component_max(point)])
    });
    match corners {
        Some([min, max]) => Rectangle::with_corners(min, max),
        None => Rectangle::new(Point::zero(), Size::new(1, 1)),
    }
}

/// Returns the pixels of an area of a picture, row by row.
pub(super) fn crop<const N: usize>(pixels: &[u8], width: u32, area: &Rectangle) -> Vec<u8> {
    let rows = pixels.chunks_exact(N * width as usize);
    let rows = rows.skip(area.top_left.y as usize);
    let (left, length) = (N * area.top_left.x as usize, N * area.size.width as usize);
    rows.take(area.size.height as usize)
        .flat_map(|row| row.iter().skip(left).take(length).copied())
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn area_contains_all_changed_pixels() {
        let previous = [0; 12];
        let mut current = previous;
        (current[5], current[10]) = (1, 1);
        // In a picture of 4x3 pixels, bytes 5 and 10 are at (1, 1) and (2, 2).
        let area = changed_area::<1>(&previous, &current, 4);
        assert_eq!(area, Rectangle::new(Point::new(1, 1), Size::new(2, 2)));
        assert_eq!(crop::<1>(&current, 4, &area), [1, 0, 0, 1]);
        assert_eq!(
            changed_area::<3>(&previous, &previous, 2).size,
            Size::new(1, 1)
        );
    }
}
