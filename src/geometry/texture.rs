//! Textures. A texture selects the material at each point of an object.

use super::point::Point;
use crate::archive::{Archive, Fields};
use crate::math::{Length, Product, high};
use crate::scene::Axis;

/// The texture of a prepared object. Materials are given by their index.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Texture {
    Uniform(u16),
    Checker(Checker),
}

/// A checkerboard pattern along two axes.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Checker {
    /// The number of cells per unit of length is `mantissa * 2^(exponent - 31)`. The top bit of the
    /// mantissa is set.
    pub(crate) mantissa: u32,
    pub(crate) exponent: i8,
    /// Position of the scene's origin within a pair of cells, along each axis. The unit is one
    /// pair, and the format is `U0F32`. A position wraps around, because the pattern repeats with
    /// each pair.
    pub(crate) phase: [u32; 2],
    pub(crate) axes: [Axis; 2],
    pub(crate) materials: [u16; 2],
}

impl Texture {
    /// Returns true if every field is in the range for which tracing is correct.
    pub(crate) fn is_valid(&self, materials: u16) -> bool {
        match self {
            Self::Uniform(material) => *material < materials,
            Self::Checker(checker) => {
                let mut used = checker.materials.iter();
                checker.mantissa >> 31 == 1 && used.all(|material| *material < materials)
            }
        }
    }

    /// Returns the index of the material at a point.
    #[inline(always)]
    pub(crate) fn material(&self, point: &Point) -> u16 {
        match self {
            Self::Uniform(material) => *material,
            Self::Checker(checker) => checker.material(point),
        }
    }
}

impl Fields for Axis {
    fn visit(&mut self, archive: &mut impl Archive) {
        let mut index = *self as u8;
        index.visit(archive);
        *self = match index {
            0 => Self::X,
            1 => Self::Y,
            _ => Self::Z,
        };
    }
}

impl Fields for Texture {
    fn visit(&mut self, archive: &mut impl Archive) {
        const UNIFORM: u8 = 0;
        const CHECKER: u8 = 1;
        let mut kind = match self {
            Self::Uniform(_) => UNIFORM,
            Self::Checker(_) => CHECKER,
        };
        kind.visit(archive);
        *self = if kind == UNIFORM {
            let mut material = match *self {
                Self::Uniform(material) => material,
                Self::Checker(_) => 0,
            };
            material.visit(archive);
            Self::Uniform(material)
        } else {
            let mut checker = match *self {
                Self::Checker(checker) => checker,
                Self::Uniform(_) => Checker::default(),
            };
            checker.mantissa.visit(archive);
            checker.exponent.visit(archive);
            checker
                .phase
                .iter_mut()
                .for_each(|phase| phase.visit(archive));
            checker.axes.iter_mut().for_each(|axis| axis.visit(archive));
            checker
                .materials
                .iter_mut()
                .for_each(|material| material.visit(archive));
            Self::Checker(checker)
        };
    }
}

impl Checker {
    #[inline(never)]
    fn material(&self, point: &Point) -> u16 {
        let parity = self.position(0, point) ^ self.position(1, point);
        self.materials[(parity >> 31) as usize]
    }

    /// Returns the position of a point within its pair of cells, along an axis. In the second cell
    /// of a pair, the top bit of the position is set.
    ///
    /// Whole pairs wrap around to zero, so the position is as exact for points in the extended
    /// range as for points in the near range (each coordinate within ±3.5).
    #[inline(always)]
    fn position(&self, axis: usize, point: &Point) -> u32 {
        let p = point.coordinates;
        let coordinate: Length = match self.axes[axis & 1] {
            Axis::X => p.x,
            Axis::Y => p.y,
            Axis::Z => p.z,
        };
        // The coordinate has Q28 and the mantissa Q31, so their product is a number of cells in
        // Q59, or a number of pairs in Q60. A later shift gives Q32. The cast of the mantissa to a
        // signed word, which every core can multiply, subtracts 2. Adding the coordinate to the
        // high word corrects the product.
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
        extended_position(product, shift).wrapping_add(self.phase[axis & 1])
    }
}

#[cold]
fn extended_position(product: i64, shift: i32) -> u32 {
    if shift > 0 {
        (product >> shift.min(63)) as u32
    } else {
        product.wrapping_shl(shift.unsigned_abs()) as u32
    }
}
