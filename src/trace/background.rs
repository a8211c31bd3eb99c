use crate::math::{Color, Product, Radiance, Unit, round_unit};
use crate::prepare::Settings;

/// Returns the radiance of a ray that hits nothing. `height` is the y component of the ray's
/// unit direction.
#[inline(always)]
pub(super) fn background(settings: &Settings, height: Unit) -> Color<Radiance> {
    if settings.is_gradient && height > 0 {
        return gradient(settings, height);
    }
    settings.horizon
}

/// Blends the colors of the horizon and the zenith linearly, by height.
#[inline(never)]
fn gradient(settings: &Settings, height: Unit) -> Color<Radiance> {
    settings.horizon.zip(settings.zenith, |horizon, zenith| {
        // No channel of the two colors exceeds 1, so no channel of the blended color exceeds 1.
        let rise = zenith.to_bits() as i32 - horizon.to_bits() as i32;
        let risen = round_unit::<30>(rise.product(height.to_bits())).to_bits();
        Radiance::from_bits(horizon.to_bits().saturating_add_signed(risen))
    })
}
