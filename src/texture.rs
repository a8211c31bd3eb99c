//! Which material covers a point of a surface.

use crate::Axis;
use crate::num::Length;
use crate::ray::Point;

/// What covers a prepared object: the numbers of materials.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Texture {
    Uniform(u16),
    Checker(Checker),
}

/// A checkerboard over two axes.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Checker {
    /// Cells per unit: `mantissa * 2^(exponent - 31)`, the top bit set.
    pub(crate) mantissa: u32,
    pub(crate) exponent: i8,
    /// Where the origin lies in its pair of cells along each axis, in pairs:
    /// `U0F32`, which wraps as the board repeats.
    pub(crate) phase: [u32; 2],
    pub(crate) axes: [Axis; 2],
    pub(crate) materials: [u16; 2],
}

impl Default for Texture {
    fn default() -> Self {
        Self::Uniform(0)
    }
}

impl Texture {
    #[inline]
    pub(crate) fn material(&self, point: Point) -> u16 {
        match self {
            Self::Uniform(material) => *material,
            Self::Checker(checker) => checker.material(point),
        }
    }
}

impl Checker {
    #[inline]
    fn material(&self, point: Point) -> u16 {
        let parity = self.position(0, point) ^ self.position(1, point);
        self.materials[(parity >> 31) as usize]
    }

    /// The place in a pair of cells: the top bit tells the odd cell.
    ///
    /// All but the position in the pair wraps away, so a far point is as
    /// right as a near one.
    #[inline(always)]
    fn position(&self, axis: usize, point: Point) -> u32 {
        let p = point.coordinates;
        let coordinate: Length = match self.axes[axis & 1] {
            Axis::X => p.x,
            Axis::Y => p.y,
            Axis::Z => p.z,
        };
        // Q28 * Q31 -> Q59, in cells; a pair is twice as long: Q60; to Q32.
        let product = i64::from(coordinate.to_bits()) * i64::from(self.mantissa);
        let shift = i32::from(self.exponent) + i32::from(point.shift) - 28;
        let pairs = if shift < 0 {
            product >> (-shift).min(63)
        } else {
            product.wrapping_shl(shift as u32)
        };
        (pairs as u32).wrapping_add(self.phase[axis & 1])
    }
}
