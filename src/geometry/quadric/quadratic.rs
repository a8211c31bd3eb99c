use crate::math::outlined::inverse_length;
use crate::math::{Length, Product, SoftFloat, Unit, Vec3, quotient, rounded, wide};

/// `a t² + 2 b t + c = 0`, the equation of a ray and a quadric.
///
/// A quadric's function is positive outside.
#[derive(Clone, Copy, Debug)]
pub(super) struct Quadratic {
    /// Q60, within ±1.
    pub(super) a: i64,
    /// Q58.
    pub(super) b: i64,
    /// Q56.
    pub(super) c: i64,
    /// `b² - a c`, Q56, found without that difference.
    pub(super) discriminant: i64,
}

impl Quadratic {
    /// The roots above 0, in no order, in steps of 2^-28.
    ///
    /// The sum `-b ± sqrt(b² - a c)` that cannot cancel gives one root as
    /// `sum / a`, the other as `c / sum`: also where a is nearly 0, for a ray
    /// along a cone's side or a cylinder's axis (Press and others, Numerical
    /// Recipes, 5.6).
    #[inline]
    pub(super) fn roots(&self) -> [Option<SoftFloat>; 2] {
        let &Self {
            a,
            b,
            c,
            discriminant,
        } = self;
        // All of one sign: the ray goes away from the surface.
        if discriminant < 0 || (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0) {
            return [None, None];
        }
        let root = if discriminant == 0 {
            0
        } else {
            root(discriminant as u64)
        };
        let sum = if b < 0 { root - b } else { -root - b };
        [ratio(sum, a), ratio(c, sum)]
    }

    /// The other root, for a start point on the surface, where c is 0.
    ///
    /// A ray through the inside always has one, but within a cone, where a may
    /// be below 0: if rounding lets a ray that grazes the surface seem to
    /// leave, the surface is met at once. Outside only a double cone is met
    /// again, where a is below 0, too.
    #[inline]
    pub(super) fn across(&self, inward: bool) -> Option<SoftFloat> {
        if self.a < 0 {
            return ratio(-2 * self.b, self.a);
        }
        inward.then(|| ratio(-2 * self.b, self.a).unwrap_or(SoftFloat::ZERO))
    }
}

/// `o × d`: not inlined, as most forms take it.
#[inline(never)]
pub(super) fn moment(o: Vec3<Length>, d: Vec3<Unit>) -> Vec3<Length> {
    o.cross(d)
}

/// A vector of any steps, each component times a factor: not inlined, as is `moment`.
#[inline(never)]
pub(super) fn squeezed(v: Vec3<i32>, factors: Vec3<Unit>) -> Vec3<i32> {
    v.zip(factors, |c, k| rounded::<30>(c.product(k.to_bits())))
}

/// The square root of Q56, as Q58.
#[inline]
fn root(square: u64) -> i64 {
    let inverse = inverse_length(square);
    // Q63 in [1/2, 1), times 2^(32 - half_shift) in steps of 2^-28
    (wide(inverse.normalized, inverse.inverse) >> (1 + inverse.half_shift)) as i64
}

/// `2^30 n / d` if it is above 0.
#[inline(never)]
fn ratio(n: i64, d: i64) -> Option<SoftFloat> {
    if n == 0 || d == 0 || (n < 0) != (d < 0) {
        return None;
    }
    Some(quotient(n.unsigned_abs(), d.unsigned_abs()))
}
