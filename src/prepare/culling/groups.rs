use core::mem;

use heapless::VecView;

use crate::geometry::CullSphere;
use crate::prepare::Object;

/// Number of neighboring objects that share one bounding sphere.
pub(crate) const GROUP: usize = 8;

/// Greatest number of bounded objects that are tested one by one. With more objects, it is
/// faster to test groups of objects first.
pub(crate) const SMALL_SCENE: usize = 2 * GROUP;

/// Fills three lists: the bounded objects, the groups of bounded objects, and the unbounded
/// objects.
pub(in crate::prepare) fn list_objects(
    objects: &[Object],
    bounded: &mut VecView<CullSphere>,
    groups: &mut VecView<CullSphere>,
    unbounded: &mut VecView<u16>,
) {
    bounded.clear();
    unbounded.clear();
    // Each of the three lists can hold as many entries as the list of objects, so no push
    // fails.
    for (object, index) in objects.iter().zip(0..) {
        let Some(bound) = object.shape.bounding_sphere() else {
            let _ = unbounded.push(index);
            continue;
        };
        let _ = bounded.push(CullSphere::new(&bound, index));
    }
    if bounded.len() > SMALL_SCENE {
        group_neighbors(bounded);
    }
    groups.clear();
    for group in bounded.chunks(GROUP) {
        let _ = groups.push(CullSphere::around(group));
    }
}

/// Sorts spheres into groups. Each group consists of one sphere and its nearest neighbors among
/// the spheres that are not in an earlier group.
fn group_neighbors(mut spheres: &mut [CullSphere]) {
    let Some(mut first) = spheres.first().copied() else {
        return;
    };
    for index in 0.. {
        let Some((next, rest)) = mem::take(&mut spheres).split_first_mut() else {
            return;
        };
        if index % GROUP == 0 {
            first = *next;
        }
        for other in rest.iter_mut() {
            if first.distance_squared(other) < first.distance_squared(next) {
                mem::swap(next, other);
            }
        }
        spheres = rest;
    }
}
