//! Vectors of three numbers: points, directions and colors.

use core::ops::{Add, Mul, Neg, Sub};

use crate::Float;

/// Point or direction in right-handed coordinates, y up.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize))]
pub struct Vec3<F> {
    pub x: F,
    pub y: F,
    pub z: F,
}

/// Linear color: red, green and blue in x, y and z.
pub type Color<F> = Vec3<F>;

/// Shorthand constructor of a [`Vec3`].
pub const fn vec3<F>(x: F, y: F, z: F) -> Vec3<F> {
    Vec3 { x, y, z }
}

impl<F: Float> Vec3<F> {
    pub const ZERO: Self = vec3(F::ZERO, F::ZERO, F::ZERO);
    pub const ONE: Self = vec3(F::ONE, F::ONE, F::ONE);

    /// Converts literals.
    pub fn lit([x, y, z]: [f64; 3]) -> Self {
        vec3(F::lit(x), F::lit(y), F::lit(z))
    }

    pub fn to_array(self) -> [F; 3] {
        [self.x, self.y, self.z]
    }

    #[inline]
    pub fn dot(self, other: Self) -> F {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    pub fn cross(self, other: Self) -> Self {
        vec3(
            self.y * other.z - self.z * other.y,
            self.z * other.x - self.x * other.z,
            self.x * other.y - self.y * other.x,
        )
    }

    #[inline]
    pub fn length(self) -> F {
        self.dot(self).sqrt()
    }

    /// Returns the vector scaled to length 1.
    #[inline]
    pub fn unit(self) -> Self {
        self * (F::ONE / self.length())
    }

    /// Multiplies component by component.
    #[inline]
    pub fn times(self, other: Self) -> Self {
        vec3(self.x * other.x, self.y * other.y, self.z * other.z)
    }

    /// Returns the greatest component.
    pub fn greatest(self) -> F {
        self.x.max(self.y).max(self.z)
    }

    #[inline]
    pub fn is_zero(self) -> bool {
        self.x == F::ZERO && self.y == F::ZERO && self.z == F::ZERO
    }
}

impl<F: Float> Add for Vec3<F> {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        vec3(self.x + other.x, self.y + other.y, self.z + other.z)
    }
}

impl<F: Float> Sub for Vec3<F> {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        vec3(self.x - other.x, self.y - other.y, self.z - other.z)
    }
}

impl<F: Float> Mul<F> for Vec3<F> {
    type Output = Self;

    #[inline]
    fn mul(self, scale: F) -> Self {
        vec3(self.x * scale, self.y * scale, self.z * scale)
    }
}

impl<F: Float> Neg for Vec3<F> {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        vec3(-self.x, -self.y, -self.z)
    }
}
