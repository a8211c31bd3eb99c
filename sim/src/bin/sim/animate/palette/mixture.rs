//! Ordered dithering with any palette.

/// Weight of the contrast between the two colors of a mixture. A larger weight prefers similar
/// colors, which makes the pattern less visible but its mean color less exact.
const CONTRAST: f32 = 0.1;

/// Number of thresholds in the dither pattern, an 8x8 Bayer matrix.
const LEVELS: f32 = 64.0;

/// Two palette colors whose mixture approximates a color.
#[derive(Clone, Copy)]
pub(super) struct Mixture {
    /// Index of the nearest palette color.
    pub(super) nearest: u8,
    other: u8,
    /// Number of pixels with the other color in a square of 8x8 pixels.
    share: u8,
}

impl Mixture {
    /// Finds the mixture for a color. `palette` has from 1 to 256 colors.
    ///
    /// The mean color of two palette colors lies on the line between them. The mixture has the
    /// palette color nearest to the color, and the other palette color for which the line passes
    /// close to the color and is not too long.
    pub(super) fn new(color: [u8; 3], palette: &[[u8; 3]]) -> Self {
        let nearest = nearest(color, palette);
        let from = |color: [u8; 3]| difference(color, palette[usize::from(nearest)]);
        let wanted = from(color);
        let mut best = Self {
            nearest,
            other: nearest,
            share: 0,
        };
        let mut least = dot(wanted, wanted);
        for (other, index) in palette.iter().zip(0..) {
            let line = from(*other);
            let length = dot(line, line);
            if length == 0.0 {
                continue;
            }
            let share = (dot(wanted, line) / length).clamp(0.0, 1.0);
            let rest = [0, 1, 2].map(|channel| wanted[channel] - share * line[channel]);
            let cost = dot(rest, rest) + CONTRAST * share * (1.0 - share) * length;
            if cost < least {
                least = cost;
                (best.other, best.share) = (index, (share * LEVELS).round() as u8);
            }
        }
        best
    }

    /// Returns the palette index of a pixel with the mixture's color.
    pub(super) fn at(self, x: u32, y: u32) -> u8 {
        match threshold(x, y) < self.share {
            true => self.other,
            false => self.nearest,
        }
    }
}

/// Returns the index of the palette color nearest to a color.
fn nearest(color: [u8; 3], palette: &[[u8; 3]]) -> u8 {
    let distance = |other: &[u8; 3]| {
        let line = difference(*other, color);
        dot(line, line)
    };
    let distances = palette.iter().map(distance).zip(0..);
    let nearest = distances.min_by(|(a, _), (b, _)| a.total_cmp(b));
    nearest.map_or(0, |(_, index)| index)
}

fn difference(a: [u8; 3], b: [u8; 3]) -> [f32; 3] {
    [0, 1, 2].map(|channel| f32::from(a[channel]) - f32::from(b[channel]))
}

fn dot(a: [f32; 3], b: [f32; 3]) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Returns the threshold of a pixel in the Bayer matrix, from 0 to 63. The bits of the threshold
/// are the bits of `x ^ y` and `y`, interleaved and in reverse order.
fn threshold(x: u32, y: u32) -> u8 {
    let bits = (0..3).map(|bit| {
        let pair = 2 * (((x ^ y) >> bit) & 1) + ((y >> bit) & 1);
        pair << (2 * (2 - bit))
    });
    bits.sum::<u32>() as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thresholds_are_all_different() {
        let pixels = (0..64).map(|index| threshold(index % 8, index / 8));
        let mut thresholds: Vec<_> = pixels.collect();
        assert_eq!(thresholds[..4], [0, 32, 8, 40]);
        thresholds.sort();
        assert!(thresholds.into_iter().eq(0..64));
    }

    #[test]
    fn mixes_similar_colors_only() {
        let gray = |level| [level; 3];
        let mixture = Mixture::new(gray(103), &[gray(100), gray(112), gray(255)]);
        assert_eq!((mixture.nearest, mixture.other, mixture.share), (0, 1, 16));
        let plain = Mixture::new(gray(103), &[gray(100), gray(255)]);
        assert_eq!((plain.nearest, plain.share), (0, 0));
    }
}
