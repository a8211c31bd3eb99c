//! Keyframe animation of cameras, objects and lights.
//!
//! An [`Animation`] is plain data that a `static` can hold.
//! [`SceneBuffer::prepare_animation`](crate::SceneBuffer::prepare_animation) prepares a scene with
//! its animation. [`SceneBuffer::decode_animation`](crate::SceneBuffer::decode_animation) reads both
//! from a compiled scene. The result is a [`PreparedAnimation`], which returns the frame at any
//! time. Times are in seconds. All arithmetic uses saturating `I32F32` fixed point, so every
//! platform computes the same frames.

mod check;
mod curve;
mod error;
mod keyframe;
mod keys;
mod prepared_animation;
mod scale;
mod script;
mod segment;
mod track;
mod values;

pub use error::{AnimationError, AnimationProblem};
pub use keyframe::{Interpolation, Keyframe};
pub use prepared_animation::PreparedAnimation;
pub use track::{Animation, Target, Track};

pub(crate) use prepared_animation::{decode, prepare};
