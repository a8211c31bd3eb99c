//! A Whitted tracer in floating point, as plain as can be: the oracle that the
//! fixed-point renderer's pictures are measured by.
//!
//! It shares no code with the renderer and takes none of its shortcuts, so an
//! error in one does not repeat itself in the other. Both are held to the same
//! reference images. This one, in f64, agrees with them nearly to the last of
//! their 16 bits, and so stands in for them at any size and for any scene.
//!
//! The core, generic over [`Float`], is `no_std` and allocates nothing. In f32
//! on a microcontroller it shows what plain floating point costs there. The
//! feature `std` adds scene files, rendering to memory and image comparison:
//!
//! ```no_run
//! let mut scene = whitted_oracle::load::<f64>("scenes/01_whitted.toml");
//! scene.settings.min_weight = 0.0;
//! let pixels = scene.render(320, 240);
//! let reference = whitted_oracle::read_png("images/01_whitted.png");
//! println!("{:.1} dB", whitted_oracle::compare(&pixels, &reference.pixels).psnr);
//! ```
//!
//! A picture's way: `scene` is the data; `view` makes eye rays; `shape` and
//! `sphereflake` find t, then the normal; `tracer` shades a hit and follows its
//! bounces.

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
