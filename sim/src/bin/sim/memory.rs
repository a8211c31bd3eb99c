use std::mem::size_of;

use whitted::SceneBuffer;

/// The bytes of a `SceneBuffer` that just holds so many objects, lights and
/// materials: its size grows linearly in each.
pub(crate) fn memory(counts: [usize; 3]) -> usize {
    let empty = size_of::<SceneBuffer<0, 0, 0>>();
    let ten = [
        size_of::<SceneBuffer<10, 0, 0>>(),
        size_of::<SceneBuffer<0, 10, 0>>(),
        size_of::<SceneBuffer<0, 0, 10>>(),
    ];
    let grown = counts
        .into_iter()
        .zip(ten)
        .map(|(count, ten)| count * (ten - empty) / 10);
    empty + grown.sum::<usize>()
}
