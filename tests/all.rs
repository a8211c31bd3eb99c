//! All tests of the library that draw pictures or read files, in one program. One program compiles
//! faster than one for each file, because each program compiles the ray tracer again.
//!
//! `cargo test --test all golden` runs the tests of the module `golden`.

#![allow(clippy::unwrap_used, clippy::expect_used)]
#![allow(
    clippy::duplicate_mod,
    reason = "examples and fuzz targets declare shared files as modules of their own"
)]

mod animation;
mod antialias;
mod antialias_contract;
mod camera_motion;
mod common;
mod compiled;
mod dirty_lines;
mod dither;
mod draw_target;
mod examples;
mod fuzz;
mod golden;
mod picture;
mod prelude;
mod prepare;
mod random_scenes;
mod reference;
mod render_progress;
mod rustdoc_images;
mod shadow_artifacts;
mod special_scenes;
mod surfaces;
mod transfer;
