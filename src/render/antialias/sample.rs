use crate::math::{Color, Radiance, wide};

/// Greatest difference of a color channel between neighbors that does not make an edge: 1/16.
const EDGE: Radiance = Radiance::from_bits(1 << 26);

/// Bit of [`AaSample::hash`] that is set if the pixel is at an edge.
const IS_EDGE: u32 = 1;

/// Bit of [`AaSample::hash`] that is set if the center ray hit nothing.
const IS_MISS: u32 = 2;

/// The memory that an [`AntialiasedRenderer`](super::AntialiasedRenderer) needs for one pixel. A
/// sample takes 16 bytes.
#[derive(Clone, Copy, Debug, Default)]
pub struct AaSample {
    /// Color of the center ray, clipped to 0..=1. In an edge pixel, the weighted sum of all
    /// rays replaces this color.
    color: Color<Radiance>,
    /// Hash of the object, material and lights at the hit of the center ray. The lowest two bits
    /// are not part of the hash. The first is [`IS_EDGE`], the second [`IS_MISS`].
    hash: u32,
}

impl AaSample {
    /// Black sample to initialize the memory with.
    pub const BLACK: Self = Self {
        color: Color::<Radiance>::BLACK,
        hash: 0,
    };

    pub(super) fn new(color: Color<Radiance>, hash: u32, is_miss: bool) -> Self {
        let miss = if is_miss { IS_MISS } else { 0 };
        Self {
            color: clip(color),
            hash: hash & !(IS_EDGE | IS_MISS) | miss,
        }
    }

    pub(super) fn color(&self) -> Color<Radiance> {
        self.color
    }

    pub(super) fn is_edge(&self) -> bool {
        self.hash & IS_EDGE != 0
    }

    /// Returns true if the center ray hit nothing.
    pub(super) fn is_miss(&self) -> bool {
        self.hash & IS_MISS != 0
    }

    /// Marks both samples as edge pixels if their hits or colors differ.
    pub(super) fn compare(&mut self, other: &mut Self) {
        let difference = self.color.zip(other.color, Radiance::abs_diff);
        let same_hit = (self.hash ^ other.hash) & !IS_EDGE == 0;
        if !same_hit || !difference.all(|d| d <= EDGE) {
            self.hash |= IS_EDGE;
            other.hash |= IS_EDGE;
        }
    }

    /// Starts the weighted sum of all rays of a pixel: multiplies the color of the center ray by
    /// `weight`. `weight` is in Q32.
    pub(super) fn start(&mut self, weight: u32) {
        self.color = weighted(self.color, weight);
    }

    /// Adds the color of a ray, times `weight`, to the weighted sum of the pixel. `weight` is in
    /// Q32.
    pub(super) fn add(&mut self, color: Color<Radiance>, weight: u32) {
        self.color = self.color.plus(weighted(clip(color), weight));
    }
}

/// Multiplies a color by a weight. The products are rounded down: `U2F30 * U0F32 -> U2F30`.
fn weighted(color: Color<Radiance>, weight: u32) -> Color<Radiance> {
    color.map(|c| Radiance::from_bits((wide(c.to_bits(), weight) >> 32) as u32))
}

/// Clips the channels of a color to 0..=1.
fn clip(color: Color<Radiance>) -> Color<Radiance> {
    color.map(|c| c.min(Radiance::ONE))
}
