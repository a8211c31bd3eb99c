//! What of a frame differs from the one before.

use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::primitives::Rectangle;

/// The least rectangle around all that differs, a pixel at least. Pixels are
/// `N` bytes, row by row.
pub(super) fn changed<const N: usize>(before: &[u8], now: &[u8], width: u32) -> Rectangle {
    let ((before, _), (now, _)) = (before.as_chunks::<N>(), now.as_chunks::<N>());
    let pairs = before.iter().zip(now).zip(0_i32..);
    let differing = pairs.filter(|((before, now), _)| before != now);
    let places = differing.map(|(_, index)| Point::new(index % width as i32, index / width as i32));
    let ends = places.fold(None, |ends: Option<[Point; 2]>, place| {
        let [least, most] = ends.unwrap_or([place, place]);
        Some([least.component_min(place), most.component_max(place)])
    });
    match ends {
        Some([least, most]) => Rectangle::with_corners(least, most),
        None => Rectangle::new(Point::zero(), Size::new(1, 1)),
    }
}

/// The bytes of a rectangle of a picture, row by row.
pub(super) fn cut<const N: usize>(pixels: &[u8], width: u32, area: &Rectangle) -> Vec<u8> {
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
    fn the_rectangle_holds_all_that_differs() {
        let before = [0; 12];
        let mut now = before;
        (now[5], now[10]) = (1, 1);
        // Of 4 by 3: at (1, 1) and (2, 2).
        let area = changed::<1>(&before, &now, 4);
        assert_eq!(area, Rectangle::new(Point::new(1, 1), Size::new(2, 2)));
        assert_eq!(cut::<1>(&now, 4, &area), [1, 0, 0, 1]);
        assert_eq!(changed::<3>(&before, &before, 2).size, Size::new(1, 1));
    }
}
