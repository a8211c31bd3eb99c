use crate::math::{Color, Real, Vec3};

/// A point light. Its intensity does not decrease with distance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Light {
    /// Position of the light in world units.
    pub position: Vec3<Real>,
    /// Intensity `id` for diffuse reflection, 0 to 256 per channel.
    pub diffuse: Color<Real>,
    /// Intensity `is` for highlights, 0 to 256 per channel.
    pub specular: Color<Real>,
}

impl Light {
    /// Returns a light that has the same intensity for diffuse reflection and for highlights.
    pub const fn point(position: Vec3<Real>, color: Color<Real>) -> Self {
        Self {
            position,
            diffuse: color,
            specular: color,
        }
    }
}
