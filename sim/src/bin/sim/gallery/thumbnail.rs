use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics_simulator::OutputImage;
use whitted::render::{DisplayColor, Output, Transfer};
use whitted::{Color, Radiance};

/// Scales a picture to another size, and returns the pixels row by row. `transfer` is the encoding
/// of both pictures.
///
/// Each pixel of the result is the mean of the area that it covers in the picture, in linear light.
pub(super) fn thumbnail(
    image: &OutputImage<Rgb888>,
    transfer: Transfer,
    size: Size,
) -> impl Iterator<Item = Rgb888> {
    let buffer = image.as_image_buffer();
    let (width, height) = buffer.dimensions();
    let (pixels, _) = buffer.into_raw().as_chunks::<3>();
    let area = u128::from(width) * u128::from(height);
    let light = light_of_levels(transfer);
    let output = Output {
        transfer,
        ..Output::default()
    };
    let positions = (0..size.height).flat_map(move |y| (0..size.width).map(move |x| (x, y)));
    positions.map(move |(x, y)| {
        let mut sums = [area / 2; 3];
        for (row, row_weight) in covered(y, height, size.height) {
            for (column, column_weight) in covered(x, width, size.width) {
                let index = row as usize * width as usize + column as usize;
                for (sum, level) in sums.iter_mut().zip(pixels[index]) {
                    *sum += u128::from(row_weight * column_weight * light[usize::from(level)]);
                }
            }
        }
        let [r, g, b] = sums.map(|sum| Radiance::from_bits((sum / area) as u32));
        Rgb888::from_radiance(Color::new(r, g, b), Point::zero(), output)
    })
}

/// Returns the radiance of each level of a channel, in Q30.
fn light_of_levels(transfer: Transfer) -> [u64; 256] {
    let mut light = [0; 256];
    for (level, light) in (0..=255).zip(&mut light) {
        *light = match transfer {
            Transfer::Linear => (u64::from(level) << 30) / 255,
            Transfer::Srgb => Color::srgb(level, 0, 0).r.to_bits().unsigned_abs() >> 2,
        };
    }
    light
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
    use embedded_graphics::prelude::*;
    use embedded_graphics_simulator::{OutputSettings, SimulatorDisplay};

    #[test]
    fn keeps_a_picture_of_the_same_size() -> Result<(), Box<dyn std::error::Error>> {
        let mut display = SimulatorDisplay::new(Size::new(16, 16));
        let levels = (0..=255).map(|level| Rgb888::new(level, 255 - level, 7));
        display.fill_contiguous(&display.bounding_box(), levels.clone())?;
        let image = display.to_rgb_output_image(&OutputSettings::default());
        for transfer in [Transfer::Linear, Transfer::Srgb] {
            let same = thumbnail(&image, transfer, display.size());
            assert!(same.eq(levels.clone()), "{transfer:?}");
        }
        Ok(())
    }

    #[test]
    fn mean_of_black_and_white_is_half_the_light() -> Result<(), Box<dyn std::error::Error>> {
        let mut display = SimulatorDisplay::new(Size::new(2, 1));
        display.fill_contiguous(&display.bounding_box(), [Rgb888::BLACK, Rgb888::WHITE])?;
        let image = display.to_rgb_output_image(&OutputSettings::default());
        for (transfer, gray) in [(Transfer::Linear, 128), (Transfer::Srgb, 188)] {
            let mean = thumbnail(&image, transfer, Size::new(1, 1)).next();
            assert_eq!(mean, Some(Rgb888::new(gray, gray, gray)));
        }
        Ok(())
    }

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
