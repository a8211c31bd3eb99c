use embedded_graphics::geometry::Size;
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics_simulator::OutputImage;

/// Scales a picture to another size, and returns the pixels row by row.
///
/// Each pixel of the result is the mean of the area that it covers in the picture. The picture has
/// linear colors, so no gamma correction is needed.
pub(super) fn thumbnail(image: &OutputImage<Rgb888>, size: Size) -> impl Iterator<Item = Rgb888> {
    let buffer = image.as_image_buffer();
    let (width, height) = buffer.dimensions();
    let (pixels, _) = buffer.into_raw().as_chunks::<3>();
    let area = u64::from(width) * u64::from(height);
    let positions = (0..size.height).flat_map(move |y| (0..size.width).map(move |x| (x, y)));
    positions.map(move |(x, y)| {
        let mut sums = [area / 2; 3];
        for (row, row_weight) in covered(y, height, size.height) {
            for (column, column_weight) in covered(x, width, size.width) {
                let index = row as usize * width as usize + column as usize;
                for (sum, sample) in sums.iter_mut().zip(pixels[index]) {
                    *sum += row_weight * column_weight * u64::from(sample);
                }
            }
        }
        let [r, g, b] = sums.map(|sum| (sum / area) as u8);
        Rgb888::new(r, g, b)
    })
}

/// Scales a line from `from` source pixels to `to` target pixels. Returns the indices and weights
/// of the source pixels that the target pixel `index` covers.
///
/// The weight is `to` for a source pixel that is fully covered, and smaller for a partly covered
/// one.
fn covered(index: u32, from: u32, to: u32) -> impl Iterator<Item = (u32, u64)> {
    let [index, from, to] = [index, from, to].map(u64::from);
    let (start, end) = (index * from, (index + 1) * from);
    (start / to..end.div_ceil(to)).map(move |source| {
        let weight = end.min((source + 1) * to) - start.max(source * to);
        (source as u32, weight)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn target_pixels_cover_all_source_pixels() {
        let three_of_four = |index| covered(index, 4, 3).collect::<Vec<_>>();
        assert_eq!(three_of_four(0), [(0, 3), (1, 1)]);
        assert_eq!(three_of_four(1), [(1, 2), (2, 2)]);
        assert_eq!(three_of_four(2), [(2, 1), (3, 3)]);
        let four_of_two = |index| covered(index, 2, 4).collect::<Vec<_>>();
        assert_eq!(
            [0, 1, 2, 3].map(|index| four_of_two(index)[0]),
            [(0, 2), (0, 2), (1, 2), (1, 2)]
        );
    }
}
