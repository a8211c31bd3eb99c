//! Number formats, vectors, colors and the integer arithmetic under them.

pub(crate) mod color;
mod crc32;
mod decimal;
mod fixed;
pub(crate) mod outlined;
mod product;
mod rotation;
mod tangent;
pub(crate) mod vector;

pub use color::Color;
pub use crc32::Crc32;
pub use fixed::{Radiance, Real};
pub use vector::Vec3;

pub(crate) use decimal::Decimal;
pub(crate) use fixed::*;
pub(crate) use product::{Product, Square};
pub(crate) use rotation::Rotation;
pub(crate) use tangent::tangent_of_half;
pub(crate) use vector::{
    bits, direction, high, normalize, round_length, round_unit, scaled, upper_word,
};
