use crate::geometry;
use crate::geometry::{Extent, Normalization};
use crate::math::Real;
use crate::scene::Scene;

/// Finds the scale of a scene. In the scaled scene, the coordinates of bounded objects, eye and
/// lights are within ±1. The coordinates of the clip boxes of planes are within ±4.
pub(super) fn normalization(scene: &Scene<'_>) -> Normalization {
    let mut extent = Extent::new(scene.camera.eye);
    for light in scene.lights {
        extent.add_point(light.position.map(Real::to_bits));
    }
    for object in scene.objects {
        geometry::extend(&object.shape, &mut extent);
    }
    let mut normalization = Normalization::fit(&extent);
    let is_alone = extent.is_point();
    for object in scene.objects {
        let exponent = geometry::max_exponent(&object.shape, normalization.center, is_alone);
        normalization = normalization.with_exponent_at_most(exponent);
    }
    normalization
}
