use std::mem::{align_of, size_of};

use whitted::SceneBuffer;
use whitted::scene::SceneCounts;

/// The bytes of a `SceneBuffer` that just holds so many objects, lights and
/// materials: so many for each, and for each object that a light sees.
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
    let both = size_of::<SceneBuffer<8, 8, 0>>() - empty;
    let seen = (both - 8 * (object + light)) / 64;
    let padded = |bytes: usize| bytes.next_multiple_of(align_of::<SceneBuffer<1, 1, 1>>());
    empty
        + padded(objects * object)
        + padded(lights * light)
        + padded(lights * objects * seen)
        + padded(materials * material)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_formula_is_that_of_the_buffer() {
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
