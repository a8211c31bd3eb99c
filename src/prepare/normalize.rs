use crate::geometry;
use crate::geometry::{Extent, Normalization};
use crate::math::Real;
use crate::scene::{Object, Scene};

/// Returns a box around the bounded objects, the eye and the lights of a scene.
pub(crate) fn extent(scene: &Scene<'_>) -> Extent {
    let mut extent = Extent::new(scene.camera.eye);
    for light in scene.lights {
        extent.add_point(light.position.map(Real::to_bits));
    }
    for object in scene.objects {
        geometry::extend(&object.shape, &mut extent);
    }
    extent
}

/// Finds the scale of a scene. In the scaled scene, the coordinates of `extent` are within ±1. The
/// coordinates of the clip boxes of planes are within ±4.
pub(crate) fn fit(extent: &Extent, objects: &[Object]) -> Normalization {
    let mut normalization = Normalization::fit(extent);
    let is_alone = extent.is_point();
    for object in objects {
        let exponent = geometry::max_exponent(&object.shape, normalization.center, is_alone);
        normalization = normalization.with_exponent_at_most(exponent);
    }
    normalization
}
