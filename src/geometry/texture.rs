//! Which material covers a point of a surface.

use crate::geometry::Point;
use crate::math::{Length, Product, high};
use crate::scene::Axis;

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

impl Texture {
    #[inline]
    pub(crate) fn material(&self, point: &Point) -> u16 {
        match self {
            Self::Uniform(material) => *material,
            Self::Checker(checker) => checker.material(point),
        }
    }
}

impl Checker {
    #[inline(never)]
    fn material(&self, point: &Point) -> u16 {
        let parity = self.position(0, point) ^ self.position(1, point);
        self.materials[(parity >> 31) as usize]
    }

    /// The place in a pair of cells: the top bit tells the odd cell.
    ///
    /// All but the position in the pair wraps away, so a far point is as
    /// right as a near one.
    #[inline(always)]
    fn position(&self, axis: usize, point: &Point) -> u32 {
        let p = point.coordinates;
        let coordinate: Length = match self.axes[axis & 1] {
            Axis::X => p.x,
            Axis::Y => p.y,
            Axis::Z => p.z,
        };
        // Q28 * Q31 -> Q59, in cells; a pair is twice as long: Q60; to Q32. The
        // mantissa less 2 fits a signed word, for which chips have a multiply.
        let product = coordinate.to_bits().product(self.mantissa as i32);
        let (high, low) = (
            high(product).wrapping_add(coordinate.to_bits()),
            product as u32,
        );
        let shift = 28 - i32::from(self.exponent) - i32::from(point.shift);
        if (1..32).contains(&shift) {
            let shift = shift as u32;
            let pairs = low >> shift | (high as u32) << 1 << (31 - shift);
            return pairs.wrapping_add(self.phase[axis & 1]);
        }
        let product = i64::from(high) << 32 | i64::from(low);
        far_position(product, shift).wrapping_add(self.phase[axis & 1])
    }
}

#[cold]
fn far_position(product: i64, shift: i32) -> u32 {
    if shift > 0 {
        (product >> shift.min(63)) as u32
    } else {
        product.wrapping_shl(shift.unsigned_abs()) as u32
    }
}
