//! What a host adds to [`whitted`]: scene files, pictures and their comparison,
//! the ray trees of pixels, and what frames take on microcontrollers.
//!
//! ```text
//! scene file ── scene_file ──> whitted::Scene ──> PreparedScene ── render ──> Picture
//!      errors with line and key <── explain <── SceneError      png16, compare <──┘
//! ```
//!
//! With `default-features = false` this is a light library for tests and for
//! build scripts of firmware; the feature `cli` adds the program `sim`.
//!
//! Floating point appears in [`compare`](mod@compare) and [`cost`] alone: scenes go from
//! decimals straight to fixed point, and pictures are integers.

pub mod compare;
pub mod cost;
pub mod flash;
pub mod picture;
pub mod png16;
pub mod ray_tree;
pub mod render;
pub mod scene_file;
