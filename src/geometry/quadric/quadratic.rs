use crate::math::{
    Length, Product, SoftFloat, Unit, Vec3, inverse_length_outlined, quotient, rounded, wide,
};

/// `a t² + 2 b t + c = 0`: the equation of a ray and a quadric whose implicit function is
/// positive outside.
#[derive(Clone, Copy, Debug)]
pub(in super::super) struct Quadratic {
    /// Q60, within ±1.
    pub(super) a: i64,
    /// Q58.
    pub(super) b: i64,
    /// Q56.
    pub(super) c: i64,
    /// `b² - a c`, Q56, computed without that difference.
    pub(super) discriminant: i64,
}

impl Quadratic {
    /// Returns the positive roots, in no order, in steps of 2^-28.
    ///
    /// The sum `-b ± sqrt(b² - a c)` that cannot cancel gives one root as `sum / a` and the
    /// other as `c / sum`. This also holds where a is nearly 0: for a ray along the side of a
    /// cone or the axis of a cylinder (Press and others, Numerical Recipes, section 5.6).
    pub(super) fn roots(&self) -> [Option<SoftFloat>; 2] {
        let &Self {
            a,
            b,
            c,
            discriminant,
        } = self;
        // Coefficients of one sign: the ray moves away from the surface.
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

    /// Returns the other root of a ray that starts on the surface, where c is 0.
    ///
    /// A ray through the inside always has another root, except within a cone, where a may be
    /// negative. If rounding makes a grazing ray seem to leave, the ray hits the surface at
    /// once. A ray on the outside can only hit a double cone again, where a is negative, too.
    pub(super) fn other_root(&self, is_inside: bool) -> Option<SoftFloat> {
        if self.a < 0 {
            return ratio(-2 * self.b, self.a);
        }
        is_inside.then(|| ratio(-2 * self.b, self.a).unwrap_or(SoftFloat::ZERO))
    }
}

/// `o × d`: the moment of the line through o along d (Plücker).
#[inline(never)]
pub(super) fn moment(o: Vec3<Length>, d: Vec3<Unit>) -> Vec3<Length> {
    o.cross(d)
}

/// Scales each component of a vector of any steps by a factor, rounded.
#[inline(never)]
pub(super) fn scaled_by_axis(v: Vec3<i32>, factors: Vec3<Unit>) -> Vec3<i32> {
    v.zip(factors, |c, k| rounded::<30>(c.product(k.to_bits())))
}

/// Square root: Q56 -> Q58.
fn root(square: u64) -> i64 {
    let inverse = inverse_length_outlined(square);
    // Q63 in [1/2, 1), times 2^(32 - half_shift) in steps of 2^-28
    (wide(inverse.normalized, inverse.inverse) >> (1 + inverse.half_shift)) as i64
}

/// Returns `2^30 n / d` if that is positive.
#[inline(never)]
fn ratio(n: i64, d: i64) -> Option<SoftFloat> {
    if n == 0 || d == 0 || (n < 0) != (d < 0) {
        return None;
    }
    Some(quotient(n.unsigned_abs(), d.unsigned_abs()))
}
