//! Computes the component of a vector along a surface normal, with a shortcut for vertical normals.
//!
//! The normal of a floor is exactly vertical. The component of a vector along this normal is the y
//! coordinate of the vector. The shortcut returns this coordinate and avoids the three products of
//! a dot product. On Armv6-M, each product would be a function call. The result is the same, bit
//! for bit.

use fixed::types::I6F58;
use long_multiply::{IS_CALL, rounded};

use super::format::{Length, Unit};
use super::product::Product;
use super::vec3::Vec3;

/// Returns the component of `v` along a plane's normal, rounded half up, in the unit of `v`.
///
/// `v` may be in any unit, but must be shorter than 2^31 units. If the normal points straight up,
/// the function returns `v.y` without a product.
#[inline(always)]
pub(crate) fn component_along(v: Vec3<i32>, normal: Vec3<Unit>) -> i32 {
    let n = normal.map(Unit::to_bits);
    // The normal of an almost horizontal plane also counts as vertical if its x and z are so small
    // that they have been rounded to 0.
    if n.x | n.z == 0 && n.y > 0 {
        return v.y;
    }
    component(v, n)
}

/// Returns the component of `v` along the unit normal `n`, which has Q30. The computation takes
/// three products.
#[inline(always)]
fn component(v: Vec3<i32>, n: Vec3<i32>) -> i32 {
    rounded::<30>(v.x.product(n.x) + v.y.product(n.y) + v.z.product(n.z))
}

impl Vec3<Unit> {
    /// Returns the cosine of the angle between a direction and a surface normal, rounded half up.
    ///
    /// `is_up` may be true only if the normal is exactly (0, 1, 0). If `is_up` is true, a shortcut
    /// without products may be used.
    #[inline(always)]
    pub(crate) fn cosine_to_normal(self, normal: Self, is_up: bool) -> Unit {
        self.cosine_by::<IS_CALL>(normal, is_up)
    }

    /// Implements [`cosine_to_normal`](Self::cosine_to_normal). The shortcut for a normal that
    /// points up is compiled only if `HAS_SHORTCUT` is true.
    #[inline(always)]
    fn cosine_by<const HAS_SHORTCUT: bool>(self, normal: Self, is_up: bool) -> Unit {
        if HAS_SHORTCUT && is_up {
            self.y
        } else {
            self.cosine(normal)
        }
    }
}

impl Vec3<Length> {
    /// Returns the exact component of the vector along a surface normal: `I4F28 * I2F30 -> I6F58`.
    ///
    /// `is_vertical` may be true only if the normal is exactly (0, 1, 0) or (0, -1, 0). If
    /// `is_vertical` is true, a shortcut without products may be used. The vector must be shorter
    /// than 8.
    #[inline(always)]
    pub(crate) fn along_normal(self, normal: Vec3<Unit>, is_vertical: bool) -> I6F58 {
        self.along_by::<IS_CALL>(normal, is_vertical)
    }

    /// Implements [`along_normal`](Self::along_normal). The shortcut for a vertical normal is
    /// compiled only if `HAS_SHORTCUT` is true.
    #[inline(always)]
    fn along_by<const HAS_SHORTCUT: bool>(self, normal: Vec3<Unit>, is_vertical: bool) -> I6F58 {
        if HAS_SHORTCUT && is_vertical {
            let up = if normal.y < Unit::ZERO {
                -self.y
            } else {
                self.y
            };
            I6F58::from_bits(i64::from(up.to_bits()) << 30)
        } else {
            self.along(normal)
        }
    }
}

#[cfg(test)]
mod tests {
    use fastrand::Rng;

    use super::*;

    const UP: Vec3<Unit> = Vec3::new(Unit::ZERO, Unit::ONE, Unit::ZERO);
    const CASES: u32 = if cfg!(miri) { 200 } else { 100_000 };

    /// Returns a random vector. The magnitudes of its components are random numbers up to 2^30.
    fn vector(random: &mut Rng) -> Vec3<i32> {
        let mut c = || random.i32(-1 << 30..=1 << 30) >> random.u32(..31);
        Vec3::new(c(), c(), c())
    }

    #[test]
    fn shortcuts_give_the_bits_of_the_products() {
        let mut random = Rng::with_seed(1);
        for _ in 0..CASES {
            let v = vector(&mut random);
            assert_eq!(component_along(v, UP), component(v, UP.map(Unit::to_bits)));

            let direction = v.map(Unit::from_bits);
            let by_shortcut = direction.cosine_by::<true>(UP, true);
            assert_eq!(by_shortcut, direction.cosine_by::<false>(UP, true));
            assert_eq!(by_shortcut, direction.cosine_to_normal(UP, true));

            let length = v.map(Length::from_bits);
            for normal in [UP, -UP] {
                let by_shortcut = length.along_by::<true>(normal, true);
                assert_eq!(by_shortcut, length.along_by::<false>(normal, true));
                assert_eq!(by_shortcut, length.along_normal(normal, true));
            }
        }
    }

    #[test]
    fn other_normals_take_the_products() {
        let mut random = Rng::with_seed(2);
        let tilted = Vec3::new(1, 1 << 30, 0).map(Unit::from_bits);
        for normal in [-UP, tilted, Vec3::new(Unit::ONE, Unit::ZERO, Unit::ZERO)] {
            for _ in 0..CASES / 10 {
                let v = vector(&mut random);
                let exact = component(v, normal.map(Unit::to_bits));
                assert_eq!(component_along(v, normal), exact);
                let direction = v.map(Unit::from_bits);
                assert_eq!(direction.cosine_by::<true>(normal, false).to_bits(), exact);
                let length = v.map(Length::from_bits);
                assert_eq!(length.along_by::<true>(normal, false), length.along(normal));
            }
        }
    }
}
