use crate::geometry::{SurfaceFlags, Texture};
use crate::prepare::{Material, Object};

/// Marks each transparent sphere that no other object touches or enters. A ray inside such a
/// sphere can hit only the sphere itself, so the ray is not tested against other objects.
pub(in crate::prepare) fn mark_isolated(objects: &mut [Object], materials: &[Material]) {
    let transmits = |index: u16| {
        let material = materials.get(usize::from(index));
        material.is_some_and(|material| !material.kt.is_black())
    };
    let is_transparent = |object: &Object| match &object.texture {
        Texture::Uniform(material) => transmits(*material),
        Texture::Checker(checker) => checker.materials.into_iter().any(transmits),
    };
    for index in 0..objects.len() {
        let sphere = objects
            .get(index)
            .filter(|object| object.shape.is_sphere() && is_transparent(object))
            .and_then(|object| object.shape.bounding_sphere());
        let Some(sphere) = sphere else {
            continue;
        };
        let mut others = objects
            .iter()
            .enumerate()
            .filter(|(other, _)| *other != index);
        let is_isolated = others.all(|(_, other)| other.shape.is_disjoint(&sphere));
        if let Some(object) = objects.get_mut(index) {
            object.flags = object.flags.with(SurfaceFlags::ISOLATED, is_isolated);
        }
    }
}
