use crate::math::{Color, Real, multiply};
use crate::scene;
use crate::scene::{Background, Light, Scene};

/// Returns the reflected ambient light of a material: `ka * ia`.
#[inline(never)]
pub(super) fn ambient(material: &scene::Material, scene: &Scene<'_>) -> Color<Real> {
    material.ka.zip(scene.ambient, multiply)
}

/// Returns the exposure of a scene. All light in the scene is divided by `2^exposure`. After
/// the division, the colors of lights and background are within 0 to 1. The radiance of a
/// surface, without its reflected and transmitted rays, is then below 4.
///
/// `brightest` returns the light with the greatest intensities that it ever has. Its arguments are
/// the number of the light and the light.
pub(crate) fn exposure(scene: &Scene<'_>, brightest: impl Fn(u16, &Light) -> Light) -> u8 {
    /// Greatest radiance of a surface after the division. The value is a little below 4 to
    /// leave room for rounding.
    const MOST: Real = Real::lit("3.99");
    let mut exponent = 0;
    let mut fit = |color, white| fit(&mut exponent, color, white);
    let lights = || {
        let lights = scene.lights.iter().zip(0..);
        lights.map(|(light, index)| brightest(index, light))
    };
    for light in lights() {
        fit(light.diffuse, Real::ONE);
        fit(light.specular, Real::ONE);
    }
    match scene.background {
        Background::Solid(color) => fit(color, Real::ONE),
        Background::Gradient { horizon, zenith } => {
            fit(horizon, Real::ONE);
            fit(zenith, Real::ONE);
        }
    }
    for material in scene.materials {
        let mut sum = ambient(material, scene).zip(material.le, Real::saturating_add);
        for light in lights() {
            let diffuse = material.kd.zip(light.diffuse, multiply);
            let specular = material.ks.zip(light.specular, multiply);
            sum = sum
                .zip(diffuse, Real::saturating_add)
                .zip(specular, Real::saturating_add);
        }
        fit(sum, MOST);
    }
    exponent
}

/// Increases `exponent` until the color, divided by `2^exponent`, is at most `white` in each channel.
#[inline(never)]
fn fit(exponent: &mut u8, color: Color<Real>, white: Real) {
    while !color.all(|c| c.to_bits() >> *exponent <= white.to_bits()) {
        *exponent += 1;
    }
}
