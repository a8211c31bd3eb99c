//! Number formats, vectors, colors and fixed-point arithmetic.
//!
//! The files of this folder form five layers: formats and products; shifts and rounding of words;
//! reciprocals, roots and powers; colors and vectors; angles. Each layer imports only the layers
//! before it. The folder imports nothing from the rest of the library.
//!
//! Functions that run for every ray are `#[inline(always)]`. Some of them have a copy that is not
//! inlined and has `_outlined` in its name. Code that runs rarely calls this copy to save flash.

mod color;
mod crc32;
mod decimal;
mod format;
mod inverse_length;
mod length_vector;
mod literal;
mod normal;
mod power;
mod product;
mod quadratic_table;
mod quotient_limit;
mod reciprocal;
mod reciprocal_root;
mod rotation;
mod scale;
mod soft_float;
mod square_root;
mod srgb;
mod tangent;
mod unit_vector;
mod vec3;
mod wide_arithmetic;
mod word;

pub use color::Color;
pub use crc32::Crc32;
pub use format::{Radiance, Real};
pub use literal::parse_literal;
pub use vec3::Vec3;

pub(crate) use decimal::Decimal;
pub(crate) use format::{
    Factor, Intensity, Length, NEAR_LIMIT, Unit, Weight, factor, radiance, weight,
};
pub(crate) use inverse_length::{InverseLength, inverse_length, inverse_length_outlined};
pub(crate) use long_multiply::{leading_zeros, rounded};
pub(crate) use normal::component_along;
pub(crate) use power::power;
pub(crate) use product::{Product, Square, wide};
pub(crate) use quotient_limit::quotient_reaches;
pub(crate) use reciprocal::{reciprocal, reciprocal_outlined};
pub(crate) use reciprocal_root::reciprocal_root;
pub(crate) use rotation::Rotation;
pub(crate) use scale::{normalize, scaled};
pub(crate) use soft_float::{SoftFloat, quotient, upper_product};
pub(crate) use square_root::square_root;
pub(crate) use tangent::tangent_of_half;
pub(crate) use unit_vector::direction;
pub(crate) use wide_arithmetic::{divide, multiply, shift_rounded};
pub(crate) use word::{bits, high, round_length, round_unit, upper_word};
