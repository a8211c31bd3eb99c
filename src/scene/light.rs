use crate::math::{Color, Real, Vec3};

/// A point light. It does not fade with distance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Light {
    /// Where it is.
    pub position: Vec3<Real>,
    /// `id`, what diffuse reflection takes from it: 0 to 256 a channel.
    pub diffuse: Color<Real>,
    /// `is`, what highlights take from it: 0 to 256 a channel.
    pub specular: Color<Real>,
}

impl Light {
    /// A light whose diffuse and specular colors are the same.
    pub const fn point(position: Vec3<Real>, color: Color<Real>) -> Self {
        Self {
            position,
            diffuse: color,
            specular: color,
        }
    }
}
