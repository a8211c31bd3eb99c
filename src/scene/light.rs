use crate::math::{Color, Real, Vec3};

/// Point light whose intensity does not fall off with distance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Light {
    /// Position in world units.
    pub position: Vec3<Real>,
    /// Intensity `id` for diffuse reflection, 0 to 256 per channel.
    pub diffuse: Color<Real>,
    /// Intensity `is` for highlights, 0 to 256 per channel.
    pub specular: Color<Real>,
}

impl Light {
    /// Returns a light with the same diffuse and specular intensity.
    pub const fn point(position: Vec3<Real>, color: Color<Real>) -> Self {
        Self {
            position,
            diffuse: color,
            specular: color,
        }
    }
}
