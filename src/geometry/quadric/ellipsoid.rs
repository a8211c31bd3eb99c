use crate::math::{Length, Product, Square, Unit, Vec3, quotient, upper_product};

use super::quadratic::{Quadratic, moment, squeezed};

/// An ellipsoid, as the sphere that it becomes when each axis is squeezed to
/// the shortest.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Ellipsoid {
    /// The shortest radius in each radius: up to 1.
    pub(crate) squeeze: Vec3<Unit>,
    /// The shortest radius.
    pub(crate) radius: Length,
}

impl Ellipsoid {
    /// The longest radius, if it is near.
    pub(super) fn longest(&self) -> Option<Length> {
        let Vec3 { x, y, z } = self.squeeze;
        let squeeze = x.min(y).min(z).to_bits() as u64;
        quotient(self.radius.to_bits() as u64, squeeze).near()
    }

    #[inline]
    fn squeezed(&self, v: Vec3<Length>) -> Vec3<Length> {
        squeezed(v.map(Length::to_bits), self.squeeze).map(Length::from_bits)
    }

    /// From `offset` of the center. The discriminant is `r² |d|² - |o × d|²`
    /// in squeezed space, which keeps the bits that `b² - a c` loses
    /// (Lagrange's identity).
    #[inline]
    pub(super) fn quadratic(&self, offset: Vec3<Length>, direction: Vec3<Unit>) -> Quadratic {
        let o = self.squeezed(offset);
        let d = squeezed(direction.map(Unit::to_bits), self.squeeze).map(Unit::from_bits);
        let a = d.dot(d).to_bits();
        let radius_squared = self.radius.square().to_bits();
        let reach = upper_product(radius_squared as u64, a as u64, 4) as i64;
        Quadratic {
            a,
            b: o.along(d).to_bits(),
            c: o.squared().to_bits() - radius_squared,
            discriminant: reach - moment(o, d).squared().to_bits(),
        }
    }

    /// Along the outward normal.
    #[inline]
    pub(super) fn gradient(&self, offset: Vec3<Length>) -> Vec3<i64> {
        self.squeezed(offset)
            .zip(self.squeeze, |c, k| c.product(k).to_bits())
    }
}
