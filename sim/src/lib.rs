//! Tools for [`whitted`] that run on the host. They read scene files, compare pictures, print the
//! ray tree of a pixel, and estimate the time of a frame on microcontrollers.
//!
//! ```text
//! scene file ── scene_file ──> whitted::Scene ──> PreparedScene ── render ──> Picture
//!      errors with line and key <── explain <── SceneError      png16, compare <──┘
//! ```
//!
//! With `default-features = false`, this crate is a small library for tests and build scripts of
//! firmware. The feature `cli` adds the program `sim`.
//!
//! In this library, only [`compare`](mod@compare) and [`cost`] use floating point. Numbers in scene
//! files are converted directly to fixed point. The samples of pictures are integers.

pub mod compare;
pub mod cost;
pub mod flash;
pub mod input;
pub mod picture;
pub mod png16;
pub mod ray_tree;
pub mod render;
pub mod scene_file;
pub mod text;
