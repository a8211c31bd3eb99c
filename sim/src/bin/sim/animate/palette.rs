//! Color palette of a GIF.

mod mixture;

use std::collections::{BTreeSet, HashMap};

use color_quant::NeuQuant;

use mixture::Mixture;

/// Largest number of colors in a GIF palette. Of the 256 indices, one is reserved for transparent
/// pixels.
const COLORS: usize = 255;

/// The colors whose channels are all 0 or 255. They are in each palette, so that every color is
/// between palette colors, even a color that no sample has.
const CORNERS: [[u8; 3]; 8] = [
    [0, 0, 0],
    [0, 0, 255],
    [0, 255, 0],
    [0, 255, 255],
    [255, 0, 0],
    [255, 0, 255],
    [255, 255, 0],
    [255, 255, 255],
];

/// Largest number of colors in the cache, which bounds its memory to a few megabytes.
const CACHED: usize = 1 << 16;

/// The palette that all frames of a GIF share. With a palette for each frame, static parts of the
/// picture would flicker.
pub(super) struct Palette {
    colors: Vec<[u8; 3]>,
    is_dithered: bool,
    /// Cache of the mixtures of palette colors that show colors.
    cache: HashMap<[u8; 3], Mixture>,
}

impl Palette {
    /// Creates a palette for the colors of some pixels. If the palette has too few colors for them,
    /// a neural net selects its colors (Dekker 1994).
    pub(super) fn new(samples: &[[u8; 3]], is_dithered: bool) -> Self {
        let mut colors = BTreeSet::from(CORNERS);
        for color in samples {
            colors.insert(*color);
            if colors.len() > COLORS {
                colors = CORNERS.into_iter().chain(select(samples)).collect();
                break;
            }
        }
        Self {
            colors: colors.into_iter().collect(),
            is_dithered,
            cache: HashMap::new(),
        }
    }

    /// Returns the palette's colors. Each color has three bytes: red, green and blue. The last
    /// color is the transparent one.
    pub(super) fn colors(&self) -> Vec<u8> {
        [self.colors.as_flattened(), &[0; 3]].concat()
    }

    /// Returns the palette index that marks transparent pixels.
    pub(super) fn transparent(&self) -> u8 {
        self.colors.len() as u8
    }

    /// Returns the palette index of each pixel of a frame. With dithering, the index depends only
    /// on the color and the position of a pixel, so that static parts of the picture do not change.
    pub(super) fn indices(&mut self, frame: &[u8], width: u32) -> Vec<u8> {
        let (pixels, _) = frame.as_chunks::<3>();
        let pixels = pixels.iter().zip(0_u32..);
        pixels
            .map(|(pixel, index)| {
                let mixture = self.mixture(*pixel);
                match self.is_dithered {
                    true => mixture.at(index % width, index / width),
                    false => mixture.nearest,
                }
            })
            .collect()
    }

    fn mixture(&mut self, color: [u8; 3]) -> Mixture {
        if self.cache.len() >= CACHED {
            self.cache.clear();
        }
        let cached = self.cache.entry(color);
        *cached.or_insert_with(|| Mixture::new(color, &self.colors))
    }
}

/// Selects the colors for a palette without the corners.
fn select(samples: &[[u8; 3]]) -> Vec<[u8; 3]> {
    let pixels = samples.iter().flat_map(|[r, g, b]| [*r, *g, *b, u8::MAX]);
    let net = NeuQuant::new(1, COLORS - CORNERS.len(), &pixels.collect::<Vec<_>>());
    net.color_map_rgb().as_chunks().0.to_vec()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(palette: &mut Palette, frame: &[[u8; 3]], width: u32) -> Vec<[u8; 3]> {
        let indices = palette.indices(frame.as_flattened(), width);
        let color = |index: u8| palette.colors[usize::from(index)];
        indices.into_iter().map(color).collect()
    }

    fn ramp() -> Vec<[u8; 3]> {
        (0..4096_u32)
            .map(|i| [(i >> 4) as u8, (i & 255) as u8, 128])
            .collect()
    }

    #[test]
    fn keeps_the_colors_of_few_samples() {
        let frame = [[4, 5, 6], [1, 2, 3], [4, 5, 6]];
        let mut palette = Palette::new(&frame, true);
        assert_eq!(palette.transparent(), 10);
        assert_eq!(palette.colors().len(), 3 * 11);
        assert_eq!(shown(&mut palette, &frame, 3), frame);
    }

    #[test]
    fn maps_many_colors_to_near_ones() {
        let mut palette = Palette::new(&ramp(), false);
        assert!(palette.colors.len() <= COLORS);
        for (pixel, shown) in ramp().iter().zip(shown(&mut palette, &ramp(), 64)) {
            assert!(pixel.iter().zip(shown).all(|(a, b)| a.abs_diff(b) < 40));
        }
    }

    /// Areas of one color have nearly the right mean color with dithering. The nearest palette
    /// colors are farther off.
    #[test]
    fn dithered_areas_have_the_right_mean() {
        let [dithered, nearest] = [true, false].map(|is_dithered| {
            let mut palette = Palette::new(&ramp(), is_dithered);
            let colors = ramp().into_iter().step_by(61);
            let errors = colors.map(|color| {
                let area = shown(&mut palette, &[color; 64], 8);
                let sums = area.iter().fold([0; 3], |sums, color| {
                    [0, 1, 2].map(|channel| sums[channel] + i32::from(color[channel]))
                });
                let channels = color.into_iter().zip(sums);
                let errors = channels.map(|(wanted, sum)| (sum - 64 * i32::from(wanted)).abs());
                errors.sum::<i32>()
            });
            errors.sum::<i32>()
        });
        assert!(dithered * 2 < nearest, "{dithered} and {nearest}");
    }

    #[test]
    fn shows_colors_that_no_sample_has() {
        let mut palette = Palette::new(&[[0, 0, 0], [255, 255, 255]], true);
        let reds = shown(&mut palette, &[[128, 0, 0]; 64], 8);
        let red = reds.iter().filter(|color| **color == [255, 0, 0]).count();
        assert!((28..=36).contains(&red), "{red}");
    }
}
