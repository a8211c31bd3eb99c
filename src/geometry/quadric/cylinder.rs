use crate::math::{Length, Product, Square, Unit, Vec3, round_length, upper_product};

use super::quadratic::Quadratic;

/// A cylinder around the y axis.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Cylinder {
    pub(crate) radius: Length,
}

impl Cylinder {
    /// From `offset` of the center, in steps of `2^shift`: a circle's, in the
    /// plane of x and z. The discriminant is `r² |d|² - (o × d)²`.
    #[inline]
    pub(super) fn quadratic(
        &self,
        offset: Vec3<Length>,
        direction: Vec3<Unit>,
        shift: u8,
    ) -> Quadratic {
        let (o, d) = (offset, direction);
        let a = (d.x.square() + d.z.square()).to_bits();
        let radius_squared = self.radius.square().to_bits() >> (2 * shift);
        let reach = upper_product(radius_squared as u64, a as u64, 4) as i64;
        let cross = o.x.product(d.z) - o.z.product(d.x);
        let cross = round_length::<30>(cross.to_bits());
        Quadratic {
            a,
            b: (o.x.product(d.x) + o.z.product(d.z)).to_bits(),
            c: (o.x.square() + o.z.square()).to_bits() - radius_squared,
            discriminant: reach - cross.square().to_bits(),
        }
    }

    /// Along the outward normal.
    #[inline]
    pub(super) fn gradient(&self, offset: Vec3<Length>) -> Vec3<i64> {
        Vec3::new(offset.x, Length::ZERO, offset.z).map(|c| c.to_bits().into())
    }
}
