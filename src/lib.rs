#![no_std]
#![forbid(unsafe_code)]
// If one of the features below is disabled, some helper functions have no caller. Without this
// attribute, the compiler would warn about these functions.
#![cfg_attr(
    not(all(
        feature = "animation",
        feature = "glass",
        feature = "quadrics",
        feature = "sphereflake"
    )),
    allow(dead_code, unused_imports)
)]
//! Whitted ray tracing in fixed point, for microcontroller displays.
//!
#![doc = concat!(
    "![A glass sphere in front of a mirror sphere over a checkerboard](data:image/png;base64,",
    include_str!("../docs/images/rustdoc/whitted.base64"),
    ")"
)]
//!
//! The crate draws spheres, quadrics, planes and sphereflakes with reflections, refractions,
//! shadows and checkerboards into any [`DrawTarget`] of embedded-graphics. The crate is `no_std`,
//! allocates nothing and does not panic. Scenes are prepared and traced with integers only, so
//! every target draws the same picture, bit for bit.
//!
//! # Start here
//!
//! Three steps lead from a scene to a picture: describe the scene, prepare it in a buffer, draw it.
//!
//! ```
//! use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb565, prelude::*};
//! use whitted::render::Picture;
//! use whitted::{
//!     Camera, Light, Material, MaterialId, Object, Scene, SceneBuffer, color, real, vec3,
//! };
//!
//! static SCENE: Scene = Scene {
//!     lights: &[Light::point(vec3!(-6, 11, 7), color!(1, 1, 1))],
//!     materials: &[Material { kd: color!(0.6, 0.04, 0.03), ..Material::BLACK }],
//!     objects: &[Object::sphere(vec3!(0, 1, 0), real!(1), MaterialId(0))],
//!     ..Scene::new(Camera::new(vec3!(0, 2, 8), vec3!(0, 1, 0), real!(33)))
//! };
//!
//! let mut display = MockDisplay::<Rgb565>::new();
//! // The buffer has room for 8 objects, 2 lights and 8 materials.
//! let mut buffer = SceneBuffer::<8, 2, 8>::new();
//! let scene = buffer.prepare(&SCENE)?;
//! Picture::new(&scene, Point::zero(), display.size()).draw(&mut display).unwrap();
//! # Ok::<(), whitted::SceneError>(())
//! ```
//!
//! # Which item for which task
//!
//! **Describe a scene.** All numbers are fixed-point numbers, [`Real`].
//!
//! | task | items |
//! |---|---|
//! | Write numbers, vectors and colors | [`real!`], [`vec3!`], [`color!`] |
//! | Describe a scene in a `static` | [`Scene`] |
//! | Place the camera | [`Camera`] |
//! | Light the scene | [`Light`], [`Scene::ambient`], [`Background`] |
//! | Place objects | [`Object`], [`Shape`], [`scene::ClipBox`] |
//! | Paint objects: matte, shiny, mirror, glass, checkerboard | [`Material`], [`MaterialId`], [`Texture`], [`scene::ior`], [`scene::SpecularModel`] |
//! | Build a scene at run time | [`scene::SceneBuilder`] |
//!
//! **Prepare it.**
//!
//! | task | items |
//! |---|---|
//! | Validate a scene and convert it to fixed point | [`SceneBuffer::prepare`], which returns a [`PreparedScene`] or a [`SceneError`] |
//! | Load a scene compiled on a PC, which takes less flash | [`SceneBuffer::decode`], [`scene_buffer!`], [`scene::SceneCounts`] |
//!
//! **Draw it.**
//!
//! | task | items |
//! |---|---|
//! | Draw a picture at a position | [`render::Picture`] |
//! | Show what is behind the objects | [`render::Picture::transparent`] |
//! | Fill a whole display | [`Renderer::draw`] |
//! | Draw in steps, coarse to fine, with other work in between | [`render::RenderProgress`], [`render::Picture::step`], [`Renderer::step`] |
//! | Feed a watchdog or read buttons while rays are traced | [`observer::Poller`] |
//! | Smooth edges | [`render::Picture::antialiased`], [`render::AntialiasedRenderer`] |
//! | Draw lines by DMA | [`Renderer::render_line`] |
//! | Send only the changed parts of a frame | [`render::DirtyLines`] |
//! | Write sRGB colors | [`Color::srgb`] |
//! | Choose sRGB output | [`Scene::transfer`] |
//! | Choose dithering | [`render::Output`] |
//! | Draw a color type of one's own | [`render::DisplayColor`] |
//!
//! **Move it.**
//!
//! | task | items |
//! |---|---|
//! | Move the camera | [`Camera::orbited`], [`PreparedScene::set_camera`] |
//! | Animate objects, lights and camera by keyframes | [`animation::Animation`], [`SceneBuffer::prepare_animation`] |
//! | Play an animation compiled on a PC | [`SceneBuffer::decode_animation`], [`animation::PreparedAnimation`] |
//!
//! **Look inside.**
//!
//! | task | items |
//! |---|---|
//! | Count rays or print the ray tree | [`observer::Stats`], [`observer::Observer`] |
//! | Store a prepared scene as bytes | [`PreparedScene::encode`] |
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
//! | [`animation::PreparedAnimation`] | 0.4 KB, in any scene |
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
//! | `embedded-graphics` | embedded-graphics' `Transform` for [`render::Picture`]; without it, the crate depends on `embedded-graphics-core` only |
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
