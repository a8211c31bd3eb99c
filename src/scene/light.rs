use crate::math::{Color, Real, Vec3};

/// A point light. Its intensity does not decrease with distance.
///
/// ```
/// use whitted::{Light, color, vec3};
///
/// // A warm lamp at the upper left.
/// let lamp = Light::point(vec3!(-6, 11, 7), color!(1, 0.9, 0.75));
/// // The same lamp, but without highlights.
/// let soft = Light { specular: color!(0, 0, 0), ..lamp };
/// # assert_eq!(soft.diffuse, lamp.specular);
/// ```
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
