use crate::geometry::{Checker, Normalization, Texture, limits};
use crate::math::{Vec3, reciprocal};
use crate::scene;
use crate::scene::{Axis, SceneError, SceneItem};

/// Validates the texture of an object and prepares it.
pub(super) fn texture(
    texture: &scene::Texture,
    normalization: &Normalization,
    item: SceneItem,
) -> Result<Texture, SceneError> {
    match *texture {
        scene::Texture::Uniform(material) => Ok(Texture::Uniform(material.0)),
        scene::Texture::Checker {
            size,
            axes,
            materials,
        } => {
            limits::resolvable_size(item, "checker.size", size, normalization)?;
            let shift = size.to_bits().leading_zeros();
            let inverse = reciprocal((((size.to_bits() as u64) << shift) >> 32) as u32);
            let Vec3 { x, y, z } = normalization.center;
            let phase = axes.map(|axis| {
                let center = match axis {
                    Axis::X => x,
                    Axis::Y => y,
                    Axis::Z => z,
                };
                fraction(center, 2 * size.to_bits())
            });
            Ok(Texture::Checker(Checker {
                mantissa: inverse,
                exponent: (shift as i32 - 32 - normalization.exponent) as i8,
                phase,
                axes,
                materials: materials.map(|material| material.0),
            }))
        }
    }
}

/// Returns the fractional part of `dividend / divisor` as `U0F32`, rounded down. The result is
/// at least 0 and below 1.
#[inline(never)]
fn fraction(dividend: i64, divisor: i64) -> u32 {
    // The divisor is never 0, but the compiler cannot know this.
    let mut remainder = dividend.checked_rem_euclid(divisor).unwrap_or(0);
    let mut quotient = 0;
    for _ in 0..32 {
        remainder *= 2;
        quotient *= 2;
        if remainder >= divisor {
            remainder -= divisor;
            quotient += 1;
        }
    }
    quotient
}
