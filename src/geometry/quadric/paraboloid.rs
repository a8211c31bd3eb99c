use fixed::types::I8F56;

use super::super::extent::Extent;
use super::super::limits;
use super::super::limits::FARTHEST;
use super::super::normalization::Normalization;
use super::super::primitive::AuthoredShape;
use super::form::QuadricForm;
use super::placed::{Placed, middle};
use super::quadratic::{Quadratic, moment};
use crate::archive;
use crate::archive::{Archive, Fields};
use crate::math::{Length, Product, Real, Square, Unit, Vec3, square_root, upper_product};
use crate::observer::ShapeKind;
use crate::scene::{SceneError, SceneItem};

/// A paraboloid in world units.
pub(in super::super) struct Authored {
    pub(in super::super) origin: Vec3<Real>,
    pub(in super::super) y: [Real; 2],
}

impl Authored {
    /// Returns the clamp without the part below the vertex, where there is no surface. A margin of
    /// 2^-10 of the upper end is kept below the vertex, so that rounding does not cut it off.
    fn ends(&self) -> [Real; 2] {
        let [low, high] = self.y;
        [low.max(-(high >> 10_u32)), high]
    }
}

impl AuthoredShape for Authored {
    type Prepared = Placed<Paraboloid>;

    fn validate(&self, item: SceneItem) -> Result<(), SceneError> {
        limits::point(item, "origin", self.origin)?;
        limits::interval(item, "y", self.y)?;
        limits::size(item, "y[1]", self.y[1])
    }

    fn extend(&self, extent: &mut Extent) {
        let y = self.ends();
        extent.add_rings(self.origin, y, y.map(|y| root(y.max(Real::ZERO))));
    }

    fn prepare(
        &self,
        normalization: &Normalization,
        item: SceneItem,
    ) -> Result<Placed<Paraboloid>, SceneError> {
        // The height and the radius at the upper end must both be at least the smallest size that
        // the scene can resolve.
        let least = limits::least_size(normalization);
        let least = least.max(least.saturating_mul(least));
        limits::range(item, "y[1]", self.y[1], [least, FARTHEST])?;
        let y = self.ends();
        // After scaling, the equation of the paraboloid is x² + z² = y 2^exponent. Multiplying x
        // and z by 2^-shift makes the exponent 0 or negative.
        let shift = (normalization.exponent.max(0) + 1) / 2;
        let form = Paraboloid {
            radius_squared: I8F56::from_bits(
                normalization.area(middle(y).to_bits()) >> (2 * shift),
            ),
            shift: shift as u8,
            g_log2: (2 * shift - normalization.exponent) as u8,
        };
        Ok(Placed::clamped(self.origin, y, normalization, form))
    }
}

/// Returns the square root of a positive number, rounded up. The number is shifted from Q32 to Q40,
/// so its root has Q20. The root is then shifted to Q32.
fn root(x: Real) -> i64 {
    (i64::from(square_root((x.to_bits() as u64) << 8)) + 1) << 12
}

/// A paraboloid around the y axis: `x² + z² = g y + r²`. The radius at the center is r, and g is
/// the growth of the squared radius along y. The coordinates x and z are multiplied by a power of
/// two, so that g is at most 1.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Paraboloid {
    /// Square of the radius at the center. The radius is scaled like x and z.
    pub(super) radius_squared: I8F56,
    /// The coordinates x and z are multiplied by `2^-shift`.
    pub(super) shift: u8,
    /// Negative logarithm of the growth g of the squared radius: `g = 2^-g_log2`, with `g_log2`
    /// from 0 to 31.
    pub(super) g_log2: u8,
}

impl Paraboloid {
    /// Returns the growth g of the squared radius along y, as `U1F31`. It is at least 2^-31.
    fn g(&self) -> u32 {
        (1_u32 << 31).unbounded_shr(self.g_log2.into())
    }
}

impl QuadricForm for Paraboloid {
    const KIND: ShapeKind = ShapeKind::Paraboloid;
    const TAG: u8 = 6;

    fn max_radius(&self, height: Length) -> Option<Length> {
        // The growth is shifted from Q28 to Q56.
        let growth = (i64::from(height.to_bits()) << 28) >> self.g_log2;
        let scaled = square_root((self.radius_squared.to_bits() + growth) as u64);
        let radius = i64::from(scaled) << self.shift;
        i32::try_from(radius).ok().map(Length::from_bits)
    }

    /// Returns the equation of a ray and the paraboloid `x² + z² = g y + r²`. For the scaled
    /// origin o, the scaled direction d and `w = o × d`, the discriminant is
    ///
    /// `r² (d_x² + d_z²) + (g d_y / 2)² + g (w_x d_z - w_z d_x) - w_y²`.
    fn quadratic(&self, offset: Vec3<Length>, direction: Vec3<Unit>, _: u8) -> Quadratic {
        let (shift, g_log2, g) = (u32::from(self.shift), u32::from(self.g_log2), self.g());
        let o = Vec3::new(offset.x >> shift, offset.y, offset.z >> shift);
        let d = Vec3::new(direction.x >> shift, direction.y, direction.z >> shift);
        let a = (d.x.square() + d.z.square()).to_bits();
        let radius_squared = self.radius_squared.to_bits();
        let reach = upper_product(radius_squared as u64, a as u64, 4) as i64;
        let w = moment(o, d);
        // `rise` is g d.y / 2. The product of Q30 and Q31 has Q61 and is shifted to Q58. The
        // square of `rise` is shifted from Q60 to Q56.
        let rise = d.y.to_bits().product(g) >> 4;
        let rise_squared = (d.y.square().to_bits() >> 6) >> (2 * g_log2).min(63);
        // `lean` is the term g (w.x d.z - w.z d.x). The products of Q28 and Q30 have Q58 and
        // are shifted to Q56.
        let lean = (w.x.product(d.z) - w.z.product(d.x)).to_bits() >> 2 >> g_log2;
        Quadratic {
            a,
            b: (o.x.product(d.x) + o.z.product(d.z)).to_bits() - rise,
            c: (o.x.square() + o.z.square()).to_bits()
                - (o.y.to_bits().product(g) >> 3)
                - radius_squared,
            discriminant: reach + rise_squared + lean - w.y.square().to_bits(),
        }
    }

    fn gradient(&self, offset: Vec3<Length>, _: u8) -> Vec3<i64> {
        let shift = 2 * u32::from(self.shift);
        // The gradient has Q32, to keep the last bits of g.
        let radial = |c: Length| c.to_bits().product(16_i32 >> shift);
        Vec3::new(radial(offset.x), -i64::from(self.g()), radial(offset.z))
    }

    fn is_valid(&self) -> bool {
        (I8F56::ZERO..=I8F56::ONE).contains(&self.radius_squared)
            && self.shift <= 2
            && self.g_log2 <= 31
    }
}

impl Fields for Paraboloid {
    fn visit(&mut self, archive: &mut impl Archive) {
        archive::fixed(&mut self.radius_squared, archive);
        self.shift.visit(archive);
        self.g_log2.visit(archive);
    }
}
