#![no_std]
#![forbid(unsafe_code)]
//! Whitted ray tracing in fixed point, for microcontroller displays.
//!
//! A [`Scene`] is plain data in world units. [`SceneBuffer::prepare`] checks it
//! and brings it to fixed point, into memory of the caller's;
//! [`SceneBuffer::decode`] reads one that was prepared before. A [`Renderer`]
//! then draws it line by line into any `DrawTarget`, and cannot fail but by the
//! display's own errors. A [`Drawing`] is drawn step by step, so that other work
//! can be done in between.
//!
//! ```
//! use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb565, prelude::*};
//! use whitted::{Camera, Color, Light, Material, MaterialId, Object, Real, Renderer, Scene, SceneBuffer, Vec3};
//!
//! static SCENE: Scene = Scene {
//!     lights: &[Light::point(Vec3::lit("-6", "11", "7"), Color::gray(Real::ONE))],
//!     materials: &[Material { kd: Color::lit("0.6", "0.04", "0.03"), ..Material::BLACK }],
//!     objects: &[Object::sphere(Vec3::lit("0", "1", "0"), Real::ONE, MaterialId(0))],
//!     ..Scene::new(Camera::new(Vec3::lit("0", "2", "8"), Vec3::lit("0", "1", "0"), Real::lit("33")))
//! };
//!
//! let mut display = MockDisplay::<Rgb565>::new();
//! let mut buffer = SceneBuffer::<8, 2, 8>::new();
//! let scene = buffer.prepare(&SCENE)?;
//! Renderer::new(&scene, display.size()).draw(&mut display).unwrap();
//! # Ok::<(), whitted::SceneError>(())
//! ```
//!
//! All that draws is 32-bit fixed point with 64-bit products: no floats, so
//! every target draws the same bits. Nothing allocates, nothing panics, and the
//! tree of rays is walked by a stack of constant size.
//!
//! To read the code, follow the data: `scene` (what is written down), `prepare`
//! (checks and scale), `camera`, `ray`, `shape`, `intersect`, `shade`, `tracer`,
//! `raster`, `pixel`, `drawing`, `renderer`, `changes`. `num` has the formats, docs/fixed-point.md why they are
//! so.

pub mod animation;
mod archive;
pub mod codec;
mod geometry;
mod math;
pub mod observer;
mod prepare;
pub mod render;
pub mod scene;
mod scene_buffer;
#[cfg(test)]
mod tests;
mod trace;

pub use codec::DecodeError;
pub use math::{Color, Radiance, Real, Vec3};
pub use prepare::PreparedScene;
pub use render::Renderer;
pub use scene::{
    Background, Camera, Light, Material, MaterialId, Object, Scene, SceneError, Shape, Texture,
};
pub use scene_buffer::SceneBuffer;

/// Runs the code in README.md.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
