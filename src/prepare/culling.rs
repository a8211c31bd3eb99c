//! Data that rejects most objects before a ray is tested against them.
//!
//! All shadow rays of a light start at one point, and most rays miss most objects, so the
//! bounds that reject them are computed once per scene. Camera rays are culled per scanline
//! instead, so that the camera may move.

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
