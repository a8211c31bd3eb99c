use crate::math::{Length, Product, Square, Unit, Vec3, quotient, round_length};

use super::quadratic::{Quadratic, moment, squeezed};

/// A cone around the y axis, squeezed to a slope of one: `x² + z² = v²` with
/// `v = radius - axial * y`. All is halved, so that no vector is 8 long.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Cone {
    /// What x and z are squeezed by: 1/2, or less for a flat cone.
    pub(crate) radial: Unit,
    /// What y is squeezed by: 1/2, or less for a steep cone; below 0 where the
    /// radius grows with y.
    pub(crate) axial: Unit,
    /// The squeezed radius at the center; below 0 beyond the apex.
    pub(crate) radius: Length,
}

impl Cone {
    /// Its largest radius so far from its center along y, if it is near.
    pub(super) fn widest(&self, height: Length) -> Option<Length> {
        let growth = round_length::<30>(height.product(self.axial.abs()).to_bits());
        let squeezed = self.radius.abs() + growth;
        quotient(
            squeezed.to_bits().max(1) as u64,
            self.radial.to_bits() as u64,
        )
        .near()
    }

    /// What x, y and z are squeezed by.
    #[inline]
    fn squeeze(&self) -> Vec3<Unit> {
        Vec3::new(self.radial, self.axial, self.radial)
    }

    /// x, v and z, in steps of `2^shift`.
    #[inline]
    fn squeezed(&self, v: Vec3<Length>, shift: u8) -> Vec3<Length> {
        let v = squeezed(v.map(Length::to_bits), self.squeeze()).map(Length::from_bits);
        Vec3::new(v.x, (self.radius >> u32::from(shift)) - v.y, v.z)
    }

    /// From `offset` of the center, in steps of `2^shift`: a sphere's of radius
    /// zero, but for the sign of v. The discriminant is the sum of the squares
    /// of `o × d`, with the opposite sign for the part without v.
    #[inline]
    pub(super) fn quadratic(
        &self,
        offset: Vec3<Length>,
        direction: Vec3<Unit>,
        shift: u8,
    ) -> Quadratic {
        let o = self.squeezed(offset, shift);
        let d = squeezed(direction.map(Unit::to_bits), self.squeeze()).map(Unit::from_bits);
        let d = Vec3::new(d.x, -d.y, d.z);
        let cross = moment(o, d).map(|c| c.square());
        Quadratic {
            a: (d.x.square() + d.z.square() - d.y.square()).to_bits(),
            b: (o.x.product(d.x) + o.z.product(d.z) - o.y.product(d.y)).to_bits(),
            c: (o.x.square() + o.z.square() - o.y.square()).to_bits(),
            discriminant: (cross.x + cross.z - cross.y).to_bits(),
        }
    }

    /// Along the normal that points away from the axis.
    #[inline]
    pub(super) fn gradient(&self, offset: Vec3<Length>, shift: u8) -> Vec3<i64> {
        self.squeezed(offset, shift)
            .zip(self.squeeze(), |c, k| c.product(k).to_bits())
    }
}
