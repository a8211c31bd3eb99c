use fixed::types::I8F56;

use crate::math::{Length, Product, Square, Unit, Vec3, square_root, upper_product};

use super::quadratic::{Quadratic, moment};

/// A paraboloid around the y axis: `x² + z² = g y + r²`, with x and z squeezed
/// by a power of two that keeps g within 1.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Paraboloid {
    /// The squeezed radius at the center, squared.
    pub(crate) radius_squared: I8F56,
    /// What x and z are squeezed by: `2^-squeeze`.
    pub(crate) squeeze: u8,
    /// `g = 2^-focus`: 0 to 31.
    pub(crate) focus: u8,
}

impl Paraboloid {
    /// g as `U1F31`: 2^-31 at least.
    #[inline]
    fn g(&self) -> u32 {
        (1_u32 << 31).unbounded_shr(self.focus.into())
    }

    /// Its largest radius so far from its center along y, if it is near.
    pub(super) fn widest(&self, height: Length) -> Option<Length> {
        // Q28 -> Q56
        let growth = (i64::from(height.to_bits()) << 28) >> self.focus;
        let squeezed = square_root((self.radius_squared.to_bits() + growth) as u64);
        let widest = i64::from(squeezed) << self.squeeze;
        i32::try_from(widest).ok().map(Length::from_bits)
    }

    /// From `offset` of the center. With `w = o × d` the discriminant is
    /// `r² |d|² + (g dy / 2)² + g (dx w_z - dz w_x) - w_y²`, |d| without dy.
    #[inline]
    pub(super) fn quadratic(&self, offset: Vec3<Length>, direction: Vec3<Unit>) -> Quadratic {
        let (squeeze, focus, g) = (u32::from(self.squeeze), u32::from(self.focus), self.g());
        let o = Vec3::new(offset.x >> squeeze, offset.y, offset.z >> squeeze);
        let d = Vec3::new(direction.x >> squeeze, direction.y, direction.z >> squeeze);
        let a = (d.x.square() + d.z.square()).to_bits();
        let radius_squared = self.radius_squared.to_bits();
        let reach = upper_product(radius_squared as u64, a as u64, 4) as i64;
        let w = moment(o, d);
        // g d.y / 2: Q30 * Q31 -> Q61 -> Q58, and its square: Q60 -> Q56
        let rise = d.y.to_bits().product(g) >> 4;
        let rise_squared = (d.y.square().to_bits() >> 6) >> (2 * focus).min(63);
        // Q28 * Q30 -> Q58 -> Q56. The cross product's signs: w_z is
        // o.x d.y - o.y d.x, the opposite of what the formula needs.
        let lean = (w.x.product(d.z) - w.z.product(d.x)).to_bits() >> 2 >> focus;
        Quadratic {
            a,
            b: (o.x.product(d.x) + o.z.product(d.z)).to_bits() - rise,
            c: (o.x.square() + o.z.square()).to_bits()
                - (o.y.to_bits().product(g) >> 3)
                - radius_squared,
            discriminant: reach + rise_squared + lean - w.y.square().to_bits(),
        }
    }

    /// Along the normal that points away from the axis.
    #[inline]
    pub(super) fn gradient(&self, offset: Vec3<Length>) -> Vec3<i64> {
        let squeeze = 2 * u32::from(self.squeeze);
        // Q32, for the sake of the last bits of g.
        let radial = |c: Length| c.to_bits().product(16_i32 >> squeeze);
        Vec3::new(radial(offset.x), -i64::from(self.g()), radial(offset.z))
    }
}
