use std::mem::{align_of, size_of};

use whitted::SceneBuffer;
use whitted::scene::SceneCounts;

/// Returns the size in bytes of a `SceneBuffer` with these capacities.
///
/// The size grows by a constant number of bytes for each object, light, material, and pair of a
/// light and an object. The capacities of a buffer are const generics, but `counts` is known only
/// at run time. The constants are therefore computed from the sizes of small buffers.
pub(crate) fn memory(counts: SceneCounts) -> usize {
    let SceneCounts {
        objects,
        lights,
        materials,
        ..
    } = counts;
    let empty = size_of::<SceneBuffer<0, 0, 0>>();
    let object = (size_of::<SceneBuffer<8, 0, 0>>() - empty) / 8;
    let light = (size_of::<SceneBuffer<0, 8, 0>>() - empty) / 8;
    let material = (size_of::<SceneBuffer<0, 0, 8>>() - empty) / 8;
    let objects_and_lights = size_of::<SceneBuffer<8, 8, 0>>() - empty;
    let pair = (objects_and_lights - 8 * (object + light)) / 64;
    let padded = |bytes: usize| bytes.next_multiple_of(align_of::<SceneBuffer<1, 1, 1>>());
    empty
        + padded(objects * object)
        + padded(lights * light)
        + padded(lights * objects * pair)
        + padded(materials * material)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn matches_the_size_of_scene_buffers() {
        let memory = |objects, lights, materials| {
            let counts = SceneCounts::EMPTY.objects(objects).lights(lights);
            memory(counts.materials(materials))
        };
        assert_eq!(memory(7, 3, 5), size_of::<SceneBuffer<7, 3, 5>>());
        assert_eq!(memory(0, 2, 0), size_of::<SceneBuffer<0, 2, 0>>());
        assert_eq!(memory(64, 8, 64), size_of::<SceneBuffer<64, 8, 64>>());
        assert_eq!(memory(5, 1, 3), size_of::<SceneBuffer<5, 1, 3>>());
    }
}
