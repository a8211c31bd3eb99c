//! The colors of a GIF.

use std::collections::{BTreeSet, HashMap};

use color_quant::NeuQuant;

/// One index is left for what does not change.
const COLORS: usize = 255;

/// The pixels that a palette is learned from.
const SAMPLES: usize = 1 << 19;

/// One palette for all frames, so that what stands still does not flicker.
pub(super) struct Palette {
    colors: Vec<u8>,
    /// Of colors that were asked for.
    known: HashMap<[u8; 3], u8>,
    learned: Option<NeuQuant>,
}

impl Palette {
    /// All colors, if there are few enough, or else those that a neural net
    /// finds (Dekker 1994).
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
                known: distinct.into_iter().zip(0..).collect(),
                learned: None,
            };
        }
        let step = (pixels().count() / SAMPLES).max(1);
        let samples: Vec<u8> = pixels()
            .step_by(step)
            .flat_map(|[r, g, b]| [*r, *g, *b, u8::MAX])
            .collect();
        let net = NeuQuant::new(1, COLORS, &samples);
        Self {
            colors: net.color_map_rgb(),
            known: HashMap::new(),
            learned: Some(net),
        }
    }

    /// Red, green and blue of each color, and of the one that is not shown.
    pub(super) fn colors(&self) -> Vec<u8> {
        [&self.colors[..], &[0; 3]].concat()
    }

    /// The index that is not shown.
    pub(super) fn transparent(&self) -> u8 {
        (self.colors.len() / 3) as u8
    }

    /// The index of the nearest color of each pixel.
    pub(super) fn indices(&mut self, frame: &[u8]) -> Vec<u8> {
        let (pixels, _) = frame.as_chunks::<3>();
        let net = &self.learned;
        let nearest = |[r, g, b]: [u8; 3]| {
            let found = net.as_ref().map(|net| net.index_of(&[r, g, b, u8::MAX]));
            found.unwrap_or_default() as u8
        };
        pixels
            .iter()
            .map(|pixel| *self.known.entry(*pixel).or_insert_with(|| nearest(*pixel)))
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn few_colors_are_kept() {
        let frames = vec![vec![1, 2, 3, 4, 5, 6], vec![7, 8, 9, 1, 2, 3]];
        let mut palette = Palette::new(&frames);
        assert_eq!(palette.colors(), [1, 2, 3, 4, 5, 6, 7, 8, 9, 0, 0, 0]);
        assert_eq!(palette.transparent(), 3);
        assert_eq!(palette.indices(&frames[1]), [2, 0]);
    }

    #[test]
    fn many_colors_are_shown_by_near_ones() {
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
