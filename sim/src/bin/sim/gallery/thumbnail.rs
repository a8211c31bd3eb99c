use embedded_graphics::geometry::Size;
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics_simulator::OutputImage;

/// The pixels of a picture at another size, row by row: each the mean of the
/// area that it covers. A display's values are linear, so their mean is too.
pub(super) fn thumbnail(image: &OutputImage<Rgb888>, size: Size) -> impl Iterator<Item = Rgb888> {
    let buffer = image.as_image_buffer();
    let (width, height) = buffer.dimensions();
    let (pixels, _) = buffer.into_raw().as_chunks::<3>();
    let area = u64::from(width) * u64::from(height);
    let places = (0..size.height).flat_map(move |y| (0..size.width).map(move |x| (x, y)));
    places.map(move |(x, y)| {
        let mut sums = [area / 2; 3];
        for (row, high) in covered(y, height, size.height) {
            for (column, wide) in covered(x, width, size.width) {
                let index = row as usize * width as usize + column as usize;
                for (sum, sample) in sums.iter_mut().zip(pixels[index]) {
                    *sum += high * wide * u64::from(sample);
                }
            }
        }
        let [r, g, b] = sums.map(|sum| (sum / area) as u8);
        Rgb888::new(r, g, b)
    })
}

/// Which of the `from` pixels of a line one of its `to` new pixels covers, and
/// how much of each, measured in steps of which an old pixel has `to`.
fn covered(place: u32, from: u32, to: u32) -> impl Iterator<Item = (u32, u64)> {
    let [place, from, to] = [place, from, to].map(u64::from);
    let (start, end) = (place * from, (place + 1) * from);
    (start / to..end.div_ceil(to)).map(move |index| {
        let steps = end.min((index + 1) * to) - start.max(index * to);
        (index as u32, steps)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn new_pixels_cover_all_old_ones() {
        let three_of_four = |place| covered(place, 4, 3).collect::<Vec<_>>();
        assert_eq!(three_of_four(0), [(0, 3), (1, 1)]);
        assert_eq!(three_of_four(1), [(1, 2), (2, 2)]);
        assert_eq!(three_of_four(2), [(2, 1), (3, 3)]);
        let four_of_two = |place| covered(place, 2, 4).collect::<Vec<_>>();
        assert_eq!(
            [0, 1, 2, 3].map(|place| four_of_two(place)[0]),
            [(0, 2), (0, 2), (1, 2), (1, 2)]
        );
    }
}
