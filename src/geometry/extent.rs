use crate::math::{Real, Vec3};

/// An axis-aligned box that encloses authored points. Its coordinates are the raw bits of a
/// [`Real`].
#[derive(Clone, Copy)]
pub(crate) struct Extent {
    pub(crate) low: Vec3<i64>,
    pub(crate) high: Vec3<i64>,
}

impl Extent {
    /// Returns an extent that contains a single point.
    pub(crate) fn new(point: Vec3<Real>) -> Self {
        let point = point.map(Real::to_bits);
        Self {
            low: point,
            high: point,
        }
    }

    /// Enlarges the extent to contain a point.
    #[inline(never)]
    pub(crate) fn add_point(&mut self, point: Vec3<i64>) {
        self.low = self.low.zip(point, i64::min);
        self.high = self.high.zip(point, i64::max);
    }

    /// Enlarges the extent to contain another one.
    pub(crate) fn add(&mut self, other: &Self) {
        self.add_point(other.low);
        self.add_point(other.high);
    }

    /// Returns a corner of the box. The lowest three bits of `index` select the high ends of x, y
    /// and z.
    pub(crate) fn corner(&self, index: u8) -> Vec3<Real> {
        let side = |bit: u8, low, high| if index & bit == 0 { low } else { high };
        let (low, high) = (self.low, self.high);
        Vec3::new(
            side(1, low.x, high.x),
            side(2, low.y, high.y),
            side(4, low.z, high.z),
        )
        .map(Real::from_bits)
    }

    /// Returns the eight corners of the box.
    pub(crate) fn corners(self) -> impl Iterator<Item = Vec3<Real>> {
        (0..8).map(move |index| self.corner(index))
    }

    /// Enlarges the extent to contain a box. The arguments are the center of the box and half
    /// of its size.
    #[inline(never)]
    pub(crate) fn add_box(&mut self, center: Vec3<Real>, half: Vec3<i64>) {
        let center = center.map(Real::to_bits);
        self.add_point(center.zip(half, |c, h| c - h));
        self.add_point(center.zip(half, |c, h| c + h));
    }

    /// Enlarges the extent to contain two horizontal circles. The values `y` are the heights
    /// of their centers above `origin`.
    #[inline(never)]
    pub(crate) fn add_rings(&mut self, origin: Vec3<Real>, y: [Real; 2], radii: [i64; 2]) {
        for (y, radius) in y.into_iter().zip(radii) {
            let center = Vec3 {
                y: origin.y + y,
                ..origin
            };
            self.add_box(center, Vec3::new(radius, 0, radius));
        }
    }

    /// Returns true if the extent contains a single point only.
    pub(crate) fn is_point(&self) -> bool {
        self.low == self.high
    }

    /// Returns the center of the box, rounded towards zero.
    pub(crate) fn center(&self) -> Vec3<i64> {
        self.low.zip(self.high, |low, high| (low + high) / 2)
    }
}
