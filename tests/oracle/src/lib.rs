//! Plain Whitted ray tracer in floating point: the oracle with which tests compare
//! the pictures of the fixed-point renderer.
//!
//! The oracle shares no code with the renderer and has none of its optimizations,
//! so a bug in one is not repeated in the other. Tests compare both with the same
//! reference images. In f64, the oracle matches these images almost to the last of
//! their 16 bits, so it can replace them at any size and for any scene.
//!
//! The core is generic over [`Float`], `no_std` and free of allocation. In f32 on a
//! microcontroller it measures the cost of plain floating point. The feature `std`
//! adds scene files, rendering to memory and image comparison:
//!
//! ```no_run
//! let mut scene = whitted_oracle::load::<f64>("tests/scenes/whitted.toml");
//! scene.settings.min_weight = 0.0;
//! let pixels = scene.render(320, 240);
//! let reference = whitted_oracle::read_png("tests/reference/images/whitted.png");
//! println!("{:.1} dB", whitted_oracle::compare(&pixels, &reference.pixels).psnr);
//! ```
//!
//! Modules in the order of the pipeline: `scene` holds the data, `view` generates
//! camera rays, `shape` and `sphereflake` intersect and compute normals, `tracer`
//! shades hits and traces secondary rays.

#![cfg_attr(not(feature = "std"), no_std)]
#![deny(unsafe_code)]

mod float;
#[cfg(feature = "std")]
mod image;
#[cfg(feature = "std")]
mod keys;
#[cfg(feature = "std")]
mod load;
mod ray;
#[cfg(feature = "std")]
mod render;
mod scene;
mod shape;
mod sphereflake;
mod tracer;
mod vec3;
mod view;

pub use float::Float;
#[cfg(feature = "std")]
pub use image::{Comparison, Image, compare, read_png};
#[cfg(feature = "std")]
pub use load::{OwnedScene, load, parse};
pub use scene::{Axis, Background, Camera, Cover, Light, Material, Model, Object, Scene, Settings};
pub use shape::Shape;
pub use sphereflake::{Sphereflake, upright_frame};
pub use vec3::{Color, Vec3, vec3};
pub use view::View;
