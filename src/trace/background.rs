use crate::math::{Color, Product, Radiance, Unit, round_unit};
use crate::prepare::Settings;

/// Radiance of a ray that hits nothing. `height` is the y component of its unit direction.
#[inline(always)]
pub(super) fn background(settings: &Settings, height: Unit) -> Color<Radiance> {
    if settings.is_gradient && height > 0 {
        return gradient(settings, height);
    }
    settings.horizon
}

/// Blends the horizon and the zenith linearly.
#[inline(never)]
fn gradient(settings: &Settings, height: Unit) -> Color<Radiance> {
    settings.horizon.zip(settings.zenith, |horizon, zenith| {
        // Both are at most 1, and so is everything between them.
        let rise = zenith.to_bits() as i32 - horizon.to_bits() as i32;
        let risen = round_unit::<30>(rise.product(height.to_bits())).to_bits();
        Radiance::from_bits(horizon.to_bits().saturating_add_signed(risen))
    })
}
