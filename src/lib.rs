#![no_std]
#![forbid(unsafe_code)]
//! Whitted ray tracing in fixed point, for microcontroller displays.

mod buffer;
mod camera;
mod checksum;
mod color;
mod compiled;
mod error;
mod intersect;
mod num;
mod observer;
mod pixel;
mod prepare;
mod prepared;
mod ray;
mod renderer;
mod scene;
mod shade;
mod shape;
mod texture;
mod tracer;
mod vector;

pub use buffer::SceneBuffer;
pub use checksum::Crc32;
pub use color::Color;
pub use error::{DecodeError, Item, Problem, SceneError};
pub use num::{Radiance, Real};
pub use observer::{Observer, RayKind, Stats};
pub use pixel::Pixel;
pub use prepared::PreparedScene;
pub use renderer::Renderer;
pub use scene::{
    Axis, Background, Bounds, Camera, Light, Material, MaterialId, Object, Scene, SceneBuilder,
    Shading, Shape, Texture, ior,
};
pub use vector::Vec3;
