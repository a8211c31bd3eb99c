//! Color palette of a GIF.

use std::collections::{BTreeSet, HashMap};

use color_quant::NeuQuant;

/// Largest number of colors in a GIF palette. Of the 256 indices, one is reserved for transparent
/// pixels.
const COLORS: usize = 255;

/// Intended number of pixels for the training of the neural net, which selects the palette's
/// colors.
const TRAINING_PIXELS: usize = 1 << 19;

/// The palette that all frames of a GIF share. With a palette for each frame, static parts of the
/// picture would flicker.
pub(super) struct Palette {
    colors: Vec<u8>,
    /// Cache of the palette indices of colors.
    cache: HashMap<[u8; 3], u8>,
    /// Neural net that maps colors to palette indices, or `None` if the palette has every color of
    /// the frames.
    net: Option<NeuQuant>,
}

impl Palette {
    /// Creates one palette for all frames. If the frames have at most 255 colors in total, the
    /// palette has all of these colors. Otherwise, a neural net selects 255 colors (Dekker 1994).
    pub(super) fn new(frames: &[Vec<u8>]) -> Self {
        let pixels = || frames.iter().flat_map(|frame| frame.as_chunks::<3>().0);
        let mut distinct = BTreeSet::new();
        for pixel in pixels() {
            distinct.insert(*pixel);
            if distinct.len() > COLORS {
                break;
            }
        }
        if distinct.len() <= COLORS {
            return Self {
                colors: distinct.iter().flatten().copied().collect(),
                cache: distinct.into_iter().zip(0..).collect(),
                net: None,
            };
        }
        let step = (pixels().count() / TRAINING_PIXELS).max(1);
        let samples: Vec<u8> = pixels()
            .step_by(step)
            .flat_map(|[r, g, b]| [*r, *g, *b, u8::MAX])
            .collect();
        let net = NeuQuant::new(1, COLORS, &samples);
        Self {
            colors: net.color_map_rgb(),
            cache: HashMap::new(),
            net: Some(net),
        }
    }

    /// Returns the palette's colors. Each color has three bytes: red, green and blue. The last
    /// color is the transparent one.
    pub(super) fn colors(&self) -> Vec<u8> {
        [&self.colors[..], &[0; 3]].concat()
    }

    /// Returns the palette index that marks transparent pixels.
    pub(super) fn transparent(&self) -> u8 {
        (self.colors.len() / 3) as u8
    }

    /// Returns the index of the nearest palette color for each pixel of a frame.
    pub(super) fn indices(&mut self, frame: &[u8]) -> Vec<u8> {
        let (pixels, _) = frame.as_chunks::<3>();
        let net = &self.net;
        let nearest = |[r, g, b]: [u8; 3]| {
            let found = net.as_ref().map(|net| net.index_of(&[r, g, b, u8::MAX]));
            found.unwrap_or_default() as u8
        };
        pixels
            .iter()
            .map(|pixel| *self.cache.entry(*pixel).or_insert_with(|| nearest(*pixel)))
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keeps_up_to_255_colors() {
        let frames = vec![vec![1, 2, 3, 4, 5, 6], vec![7, 8, 9, 1, 2, 3]];
        let mut palette = Palette::new(&frames);
        assert_eq!(palette.colors(), [1, 2, 3, 4, 5, 6, 7, 8, 9, 0, 0, 0]);
        assert_eq!(palette.transparent(), 3);
        assert_eq!(palette.indices(&frames[1]), [2, 0]);
    }

    #[test]
    fn maps_many_colors_to_near_ones() {
        let ramp: Vec<u8> = (0..4096_u32)
            .flat_map(|i| [(i >> 4) as u8, (i & 255) as u8, 128])
            .collect();
        let mut palette = Palette::new(std::slice::from_ref(&ramp));
        let indices = palette.indices(&ramp);
        for (pixel, index) in ramp.as_chunks::<3>().0.iter().zip(indices) {
            let at = 3 * usize::from(index);
            let shown = &palette.colors()[at..at + 3];
            assert!(pixel.iter().zip(shown).all(|(a, b)| a.abs_diff(*b) < 24));
        }
    }
}
