use crate::math::{
    Length, Product, SoftFloat, Unit, Vec3, inverse_length_outlined, quotient, rounded, wide,
};

/// The quadratic equation `a t² + 2 b t + c = 0`. Its roots are the distances t at which a ray hits
/// a quadric. Outside of the quadric, the left side is positive.
#[derive(Clone, Copy, Debug)]
pub(in super::super) struct Quadratic {
    /// Coefficient of t², in Q60, within ±1.
    pub(super) a: i64,
    /// Half of the coefficient of t, in Q58.
    pub(super) b: i64,
    /// Constant term, in Q56.
    pub(super) c: i64,
    /// The value of `b² - a c`, in Q56. Each quadric computes it with another formula, because this
    /// subtraction loses bits.
    pub(super) discriminant: i64,
}

impl Quadratic {
    /// Returns the positive roots in units of 2^-28, in no particular order.
    ///
    /// Of the two sums `-b ± sqrt(b² - a c)`, the one that cannot cancel gives both roots: one
    /// is `sum / a`, the other `c / sum`. The formula also holds if a is nearly 0, as for a ray
    /// along the side of a cone or the axis of a cylinder (Press and others, Numerical Recipes,
    /// section 5.6).
    pub(super) fn roots(&self) -> [Option<SoftFloat>; 2] {
        let &Self {
            a,
            b,
            c,
            discriminant,
        } = self;
        // If `a`, `b` and `c` all have the same sign, no root is positive.
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

    /// Returns the root other than 0 for a ray that starts on the surface, where c is 0.
    ///
    /// If `a` is negative, which is possible only for a cone, the ray may hit the other half of the
    /// double cone or nothing. Otherwise, only a ray through the inside hits the surface again. If
    /// rounding makes such a ray seem to leave the inside, the result is 0.
    pub(super) fn other_root(&self, is_inside: bool) -> Option<SoftFloat> {
        if self.a < 0 {
            return ratio(-2 * self.b, self.a);
        }
        is_inside.then(|| ratio(-2 * self.b, self.a).unwrap_or(SoftFloat::ZERO))
    }
}

/// Returns `o × d`, the moment of the line through the point o in the direction d (Plücker).
pub(super) fn moment(o: Vec3<Length>, d: Vec3<Unit>) -> Vec3<Length> {
    o.cross(d)
}

/// Multiplies each component of a vector by its own factor and rounds the products. The vector may
/// be in any unit.
pub(super) fn scaled_by_axis(v: Vec3<i32>, factors: Vec3<Unit>) -> Vec3<i32> {
    v.zip(factors, |c, k| rounded::<30>(c.product(k.to_bits())))
}

/// Returns the square root of a number in Q56. The root has Q58.
fn root(square: u64) -> i64 {
    let inverse = inverse_length_outlined(square);
    // The product is a Q63 number in [1/2, 1). Multiplied by 2^(32 - half_shift), it is the
    // root in units of 2^-28.
    (wide(inverse.normalized, inverse.inverse) >> (1 + inverse.half_shift)) as i64
}

/// Returns `2^30 n / d`, or `None` if this value is not positive.
fn ratio(n: i64, d: i64) -> Option<SoftFloat> {
    if n == 0 || d == 0 || (n < 0) != (d < 0) {
        return None;
    }
    Some(quotient(n.unsigned_abs(), d.unsigned_abs()))
}
