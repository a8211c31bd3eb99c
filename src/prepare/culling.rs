//! Computes the bounds that exclude most objects before a ray is tested against them.
//!
//! Most rays miss most objects. All shadow rays of a light start at the light, so the bounds
//! for these rays are computed once per scene. The camera may move, so the bounds for camera
//! rays are computed for each scanline.

mod groups;
mod isolation;
mod light_cones;
mod occlusion;

pub(super) use groups::list_objects;
pub(crate) use groups::{GROUP, SMALL_SCENE};
pub(super) use isolation::mark_isolated;
pub(super) use light_cones::build_light_cones;
pub(super) use occlusion::mark_unoccluded;

#[cfg(test)]
mod tests;
