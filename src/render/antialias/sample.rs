use crate::math::{Color, Radiance, wide};

/// Neighbors that differ by more in a channel make an edge: 1/16.
const EDGE: Radiance = Radiance::from_bits(1 << 26);

/// What is remembered of a pixel until its neighbors are known: 16 bytes.
#[derive(Clone, Copy, Debug, Default)]
pub struct AaSample {
    /// Clipped to 0..=1; the mean so far, once more rays are added.
    color: Color<Radiance>,
    /// What is seen. The lowest bit tells that it is at an edge.
    key: u32,
}

impl AaSample {
    /// What memory may be filled with.
    pub const BLACK: Self = Self {
        color: Color::<Radiance>::BLACK,
        key: 0,
    };

    pub(super) fn new(color: Color<Radiance>, key: u32) -> Self {
        Self {
            color: clipped(color),
            key: key & !1,
        }
    }

    pub(super) fn color(&self) -> Color<Radiance> {
        self.color
    }

    pub(super) fn is_edge(&self) -> bool {
        self.key & 1 != 0
    }

    /// Notes in both if they differ.
    pub(super) fn compare(&mut self, other: &mut Self) {
        let looks_alike = self.color.zip(other.color, Radiance::abs_diff);
        if (self.key ^ other.key) >> 1 != 0 || !looks_alike.all(|difference| difference <= EDGE) {
            self.key |= 1;
            other.key |= 1;
        }
    }

    /// Takes what is there for one of several rays, each of which has a share in
    /// the mean of `share`, Q32.
    pub(super) fn start(&mut self, share: u32) {
        self.color = part(self.color, share);
    }

    /// Adds another of them.
    pub(super) fn add(&mut self, color: Color<Radiance>, share: u32) {
        self.color = self.color.plus(part(clipped(color), share));
    }
}

/// `U2F30 * U0F32 -> U2F30`
fn part(color: Color<Radiance>, share: u32) -> Color<Radiance> {
    color.map(|c| Radiance::from_bits((wide(c.to_bits(), share) >> 32) as u32))
}

/// Light beyond 1 is not shown.
fn clipped(color: Color<Radiance>) -> Color<Radiance> {
    color.map(|c| c.min(Radiance::ONE))
}
