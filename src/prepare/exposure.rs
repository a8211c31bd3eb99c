use crate::math::{Color, Real};
use crate::scene;
use crate::scene::{Background, Scene};

/// Returns `ka * ia`.
pub(super) fn ambient(material: &scene::Material, scene: &Scene<'_>) -> Color<Real> {
    material
        .ka
        .zip(scene.ambient, |ka, ia| ka.saturating_mul(ia))
}

/// Exponent of the power of two that divides all light of a scene, so that lights and
/// background fit 0 to 1, and the radiance of one hit stays below 4.
pub(super) fn exposure(scene: &Scene<'_>) -> u8 {
    /// A little below 4, which leaves room for roundings.
    const MOST: Real = Real::lit("3.99");
    let mut exponent = 0;
    let mut fit = |color: Color<Real>, white: Real| {
        while !color.all(|c| c.to_bits() >> exponent <= white.to_bits()) {
            exponent += 1;
        }
    };
    for light in scene.lights {
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
        for light in scene.lights {
            let diffuse = material.kd.zip(light.diffuse, |k, i| k * i);
            let specular = material.ks.zip(light.specular, |k, i| k * i);
            sum = sum
                .zip(diffuse, Real::saturating_add)
                .zip(specular, Real::saturating_add);
        }
        fit(sum, MOST);
    }
    exponent
}
