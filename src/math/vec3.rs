use core::ops::{Add, Neg, Sub};

use super::format::Real;

/// A point or a vector. The x axis points right, the y axis up, and the z axis towards the
/// viewer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Vec3<T> {
    /// Component to the right.
    pub x: T,
    /// Component upward.
    pub y: T,
    /// Component towards the viewer.
    pub z: T,
}

impl<T> Vec3<T> {
    /// Creates the vector (x, y, z).
    pub const fn new(x: T, y: T, z: T) -> Self {
        Self { x, y, z }
    }

    /// Applies `f` to each component.
    pub(crate) fn map<U>(self, f: impl Fn(T) -> U) -> Vec3<U> {
        Vec3::new(f(self.x), f(self.y), f(self.z))
    }

    /// Returns true if `f` holds for all three components.
    pub(crate) fn all(self, f: impl Fn(T) -> bool) -> bool {
        f(self.x) && f(self.y) && f(self.z)
    }

    /// Combines two vectors component by component.
    pub(crate) fn zip<U, V>(self, other: Vec3<U>, f: impl Fn(T, U) -> V) -> Vec3<V> {
        Vec3::new(f(self.x, other.x), f(self.y, other.y), f(self.z, other.z))
    }
}

impl Vec3<Real> {
    /// Parses a vector: `Vec3::lit("0.2", "2.3", "8.2")`. Use the macro [`vec3!`](crate::vec3!)
    /// unless the texts are in variables.
    ///
    /// In a constant, a malformed literal is a compile error. Outside of constants, the function
    /// links a parser of 42 KB, and panics if a text is malformed.
    pub const fn lit(x: &str, y: &str, z: &str) -> Self {
        Self::new(Real::lit(x), Real::lit(y), Real::lit(z))
    }
}

impl<T: Add<Output = T>> Add for Vec3<T> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.zip(other, T::add)
    }
}

impl<T: Sub<Output = T>> Sub for Vec3<T> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self.zip(other, T::sub)
    }
}

impl<T: Neg<Output = T>> Neg for Vec3<T> {
    type Output = Self;
    fn neg(self) -> Self {
        self.map(T::neg)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_requires_every_component() {
        let is_set = |bits: i32| Vec3::new(bits & 1, bits & 2, bits & 4).all(|c| c != 0);
        for bits in 0..8 {
            assert_eq!(is_set(bits), bits == 7, "{bits:03b}");
        }
    }
}
