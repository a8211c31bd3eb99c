use crate::math::{Real, Vec3};

/// An axis-aligned box around authored points, in the bits of a [`Real`].
#[derive(Clone, Copy)]
pub(crate) struct Extent {
    pub(crate) low: Vec3<i64>,
    pub(crate) high: Vec3<i64>,
}

impl Extent {
    /// Returns the box of one point.
    pub(crate) fn new(point: Vec3<Real>) -> Self {
        let point = point.map(Real::to_bits);
        Self {
            low: point,
            high: point,
        }
    }

    /// Adds a point.
    pub(crate) fn add_point(&mut self, point: Vec3<i64>) {
        self.low = self.low.zip(point, i64::min);
        self.high = self.high.zip(point, i64::max);
    }

    /// Adds a box, given by its center and its half size.
    pub(crate) fn add_box(&mut self, center: Vec3<Real>, half: Vec3<i64>) {
        let center = center.map(Real::to_bits);
        self.add_point(center.zip(half, |c, h| c - h));
        self.add_point(center.zip(half, |c, h| c + h));
    }

    /// Adds two circles around the y axis through `origin`, at the heights `y` above it.
    pub(crate) fn add_rings(&mut self, origin: Vec3<Real>, y: [Real; 2], radii: [i64; 2]) {
        for (y, radius) in y.into_iter().zip(radii) {
            let center = Vec3 {
                y: origin.y + y,
                ..origin
            };
            self.add_box(center, Vec3::new(radius, 0, radius));
        }
    }

    /// Returns true if all points added so far are one and the same.
    pub(crate) fn is_point(&self) -> bool {
        self.low == self.high
    }

    /// Center of the box, rounded towards zero.
    pub(crate) fn center(&self) -> Vec3<i64> {
        self.low.zip(self.high, |low, high| (low + high) / 2)
    }
}
