//! Directions of reflected and refracted rays.

use crate::math::{
    Length, Product, Square, Unit, Vec3, inverse_length_outlined, round_unit, rounded, scaled, wide,
};

/// Returns the direction of a reflected ray, `V + 2 c n`. The error is below 3 * 2^-30.
///
/// `view` is the direction V of the incoming ray. `normal` is the normal n, which faces the ray.
/// `cosine` is `c = -V · n`, at least 0. The term `2 c n` may overflow, but the sum then wraps to
/// the correct value.
pub(crate) fn mirrored(view: Vec3<Unit>, normal: Vec3<Unit>, cosine: Unit) -> Vec3<Unit> {
    let turn = scaled::<29>(normal.map(Unit::to_bits), cosine.to_bits());
    view.zip(turn.map(Unit::from_bits), Unit::wrapping_add)
        .renormalized()
}

/// Returns the direction of a refracted ray: `η V + (η c - sqrt(k)) n`, where
/// `k = 1 - η² (1 - c²)`. Returns `None` if k < 0, which means total internal reflection.
///
/// `view` is the direction V of the incoming ray. `normal` is the normal n, which faces the ray.
/// `cosine` is `c = -V · n`, at least 0. `eta` is η, the index of refraction on the ray's side
/// divided by the index on the other side. It is 1/4 to 4. The error of the direction is below
/// 2^-20 if sqrt(k) is above 2^-10.
pub(crate) fn refracted(
    view: Vec3<Unit>,
    normal: Vec3<Unit>,
    cosine: Unit,
    eta: Length,
) -> Option<Vec3<Unit>> {
    // The squared sine is 1 - c², converted from Q60 to U0F32. η² is converted from I8F56 to
    // U5F27. Their product has Q59.
    let sine_squared = ((1 << 60) - cosine.square().to_bits()).max(0) >> 28;
    let sine_squared = sine_squared.min(u32::MAX.into()) as u32;
    let eta_squared = (eta.square().to_bits() >> 29) as u32;
    let k = (1 << 59) - wide(sine_squared, eta_squared) as i64;
    if k < 0 {
        return None;
    }
    // k is converted from Q59 to Q56, so its root has Q28. The product η c of I4F28 and I2F30
    // is rounded to Q28.
    let root = inverse_length_outlined((k >> 3) as u64).length() as i32;
    let along = rounded::<30>(eta.product(cosine).to_bits()) - root;
    let direction = view.zip(normal, |v, n| {
        let sum = eta.product(v).to_bits() + along.product(n.to_bits());
        round_unit::<28>(sum)
    });
    Some(direction.renormalized())
}
