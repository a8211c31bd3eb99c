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

mod acceleration;
mod angle;
mod animation;
mod antialias;
mod budget;
mod buffer;
mod camera;
mod changes;
mod checksum;
mod color;
mod compiled;
mod coverage;
mod drawing;
mod error;
mod exact;
mod intersect;
mod num;
mod observer;
mod optics;
mod output;
mod pixel;
mod prepare;
mod prepared;
mod raster;
mod ray;
mod renderer;
mod scene;
mod shade;
mod shadow;
mod shape;
mod texture;
mod tracer;
mod vector;

pub use animation::{
    Animation, AnimationError, AnimationProblem, Interpolation, Key, Stage, Target, Track,
};
pub use antialias::{AntialiasError, Antialiased, Sample, Samples};
pub use buffer::SceneBuffer;
pub use changes::Changes;
pub use checksum::Crc32;
pub use color::Color;
pub use compiled::counts;
pub use drawing::{Drawing, Step};
pub use error::{DecodeError, Item, Problem, SceneError};
pub use num::{Radiance, Real};
pub use observer::{Node, Observer, RayKind, ShapeKind, Stats};
pub use output::{Dither, Output, Transfer};
pub use pixel::Pixel;
pub use prepared::PreparedScene;
pub use renderer::Renderer;
pub use scene::{
    Axis, Background, Bounds, Camera, Light, Material, MaterialId, Object, Scene, SceneBuilder,
    Shading, Shape, Texture, ior,
};
pub use vector::Vec3;

/// Runs the code in README.md.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
