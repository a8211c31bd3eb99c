#![no_std]
#![forbid(unsafe_code)]
// If one of the features below is disabled, some helper functions have no caller. Without this
// attribute, the compiler would warn about these functions.
#![cfg_attr(
    not(all(feature = "glass", feature = "quadrics", feature = "sphereflake")),
    allow(dead_code, unused_imports)
)]
//! Whitted ray tracing in fixed point, for microcontroller displays.
//!
//! The crate draws spheres, quadrics, planes and sphereflakes with reflections, refractions,
//! shadows and checkerboards. It draws line by line into any [`DrawTarget`] of
//! embedded-graphics. The crate is `no_std`, allocates nothing and does not panic. Scenes are
//! prepared and traced with integers only, so every target draws the same picture, bit for bit.
//!
//! # Example
//!
//! ```
//! use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb565, prelude::*};
//! use whitted::{
//!     Camera, Color, Light, Material, MaterialId, Object, Real, Renderer, Scene, SceneBuffer,
//!     color, real, vec3,
//! };
//!
//! static SCENE: Scene = Scene {
//!     lights: &[Light::point(vec3!(-6, 11, 7), Color::gray(Real::ONE))],
//!     materials: &[Material { kd: color!(0.6, 0.04, 0.03), ..Material::BLACK }],
//!     objects: &[Object::sphere(vec3!(0, 1, 0), Real::ONE, MaterialId(0))],
//!     ..Scene::new(Camera::new(vec3!(0, 2, 8), vec3!(0, 1, 0), real!(33)))
//! };
//!
//! let mut display = MockDisplay::<Rgb565>::new();
//! let mut buffer = SceneBuffer::<8, 2, 8>::new();
//! let scene = buffer.prepare(&SCENE)?;
//! Renderer::new(&scene, display.size()).draw(&mut display).unwrap();
//! # Ok::<(), whitted::SceneError>(())
//! ```
//!
//! # Which item for which task
//!
//! | task | items |
//! |---|---|
//! | Describe a scene in a `static` | [`Scene`], [`Camera`], [`Light`], [`Material`], [`Object`], [`Shape`], [`Texture`] |
//! | Build a scene at run time | [`scene::SceneBuilder`] |
//! | Validate a scene and convert it to fixed point | [`SceneBuffer::prepare`], which returns a [`PreparedScene`] or a [`SceneError`] |
//! | Load a scene compiled on a PC | [`SceneBuffer::decode`], [`scene_buffer!`] |
//! | Draw a picture | [`Renderer::draw`] |
//! | Draw lines by DMA | [`Renderer::render_line`] |
//! | Draw in steps, coarse to fine, with other work in between | [`render::RenderProgress`], [`Renderer::step`] |
//! | Smooth edges | [`render::AntialiasedRenderer`] |
//! | Send only the changed parts of a frame | [`render::DirtyLines`] |
//! | Choose dithering and sRGB | [`render::Output`], [`Renderer::set_output`] |
//! | Draw a color type of one's own | [`render::DisplayColor`] |
//! | Move the camera | [`Camera::orbited`], [`PreparedScene::set_camera`] |
//! | Animate a scene | [`animation::Animation`], [`animation::AnimatedScene`] |
//! | Count rays or print the ray tree | [`observer::Stats`], [`observer::Observer`] |
//!
//! # Memory
//!
//! The caller provides all memory. The table shows the sizes on a 32-bit core:
//!
//! | what | bytes |
//! |---|---|
//! | [`SceneBuffer`] | 146 + 12 per light for each object, 28 per light, 68 per material |
//! | [`Renderer`] | 0.7 KB |
//! | stack while drawing | 1.8 KB, and up to 2 KB more for more than 8 generations and sphereflakes |
//! | [`render::AntialiasedRenderer`] | 0.9 KB, and 32 per pixel of the picture's width |
//! | [`render::DirtyLines`] | 4 per 32 pixels |
//! | [`animation::AnimatedScene`] | 144 per object, 72 per light |
//!
//! # Cargo features
//!
//! All features are additive and enabled by default. Disabling a feature saves flash. If a scene
//! needs a disabled feature, preparing or decoding it returns an error that names the feature. For
//! all other scenes, a feature does not change a pixel.
//!
//! | feature | enables |
//! |---|---|
//! | `quadrics` | ellipsoids, cylinders, cones and paraboloids |
//! | `sphereflake` | sphereflakes |
//! | `glass` | materials that transmit light |
//! | `antialiasing` | [`render::AntialiasedRenderer`] |
//! | `animation` | the module [`animation`] |
//!
//! [`DrawTarget`]: embedded_graphics_core::draw_target::DrawTarget

#[cfg(feature = "animation")]
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
#[doc(hidden)]
pub use math::parse_literal;
pub use math::{Color, Radiance, Real, Vec3};
pub use prepare::PreparedScene;
pub use render::Renderer;
pub use scene::{
    Background, Camera, Light, Material, MaterialId, Object, Scene, SceneError, Shape, Texture,
};
pub use scene_buffer::SceneBuffer;

/// Compiles the code blocks of README.md as doctests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
