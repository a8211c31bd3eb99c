use crate::{Real, Vec3};

/// A pinhole camera.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Camera {
    /// The eye point.
    pub eye: Vec3<Real>,
    /// What is in the middle of the picture. Only its direction from the eye counts.
    pub look_at: Vec3<Real>,
    /// A direction that points up in the picture.
    pub up: Vec3<Real>,
    /// Vertical field of view in degrees, 1 to 170.
    pub fovy_deg: Real,
}

impl Camera {
    /// A camera that is held upright: `up` is +y.
    pub const fn new(eye: Vec3<Real>, look_at: Vec3<Real>, fovy_deg: Real) -> Self {
        Self {
            eye,
            look_at,
            up: Vec3::new(Real::ZERO, Real::ONE, Real::ZERO),
            fovy_deg,
        }
    }
}
