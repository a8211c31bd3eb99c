use std::mem::{align_of, size_of};

use whitted::SceneBuffer;

/// The bytes of a `SceneBuffer` that just holds so many objects, lights and
/// materials: so many for each, and for each object that a light sees.
pub(crate) fn memory([objects, lights, materials]: [usize; 3]) -> usize {
    let empty = size_of::<SceneBuffer<0, 0, 0>>();
    let object = (size_of::<SceneBuffer<10, 0, 0>>() - empty) / 10;
    let light = (size_of::<SceneBuffer<0, 10, 0>>() - empty) / 10;
    let material = (size_of::<SceneBuffer<0, 0, 10>>() - empty) / 10;
    let both = size_of::<SceneBuffer<10, 10, 0>>() - empty;
    let seen = (both - 10 * (object + light)) / 100;
    let all = empty + objects * object + lights * (light + objects * seen) + materials * material;
    all.next_multiple_of(align_of::<SceneBuffer<1, 1, 1>>())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_formula_is_that_of_the_buffer() {
        assert_eq!(memory([7, 3, 5]), size_of::<SceneBuffer<7, 3, 5>>());
        assert_eq!(memory([0, 2, 0]), size_of::<SceneBuffer<0, 2, 0>>());
    }
}
