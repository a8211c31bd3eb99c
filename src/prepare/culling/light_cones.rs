use crate::geometry::LightCone;
use crate::prepare::{Light, Object};

/// For each light and each bounded object, computes the cone that starts at the light and
/// encloses the object. Also marks each light that an unbounded object may hide from a
/// bounded object.
pub(in crate::prepare) fn build_light_cones(
    lights: &mut [Light],
    objects: &[Object],
    unbounded: &[u16],
    cones: &mut [LightCone],
) {
    let bounded = || {
        let with_bounds = objects.iter().zip(0..);
        with_bounds.filter_map(|(object, index)| Some((object.shape.bounding_sphere()?, index)))
    };
    let mut cones = cones.chunks_mut(bounded().count().max(1));
    for light in lights {
        let position = light.position;
        let cones = cones.next().unwrap_or_default();
        light.is_occluded_by_planes = false;
        for ((bound, index), cone) in bounded().zip(cones) {
            *cone = LightCone::new(&bound, position, index);
            light.is_occluded_by_planes |= unbounded.iter().any(|unbounded| {
                let object = objects.get(usize::from(*unbounded));
                object.is_some_and(|object| object.shape.may_separate(position, &bound))
            });
        }
    }
}
