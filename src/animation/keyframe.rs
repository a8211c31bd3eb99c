use crate::archive::{self, Archive, Fields};
use crate::math::{Real, Vec3};

/// Value of an animated property at a given time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Keyframe {
    /// Time in seconds. The time must be from 0 to the animation's duration. It must not be
    /// earlier than the time of the previous keyframe.
    ///
    /// Two keyframes may have the same time. If their values differ, the property jumps from
    /// the first value to the second. If their values are equal, a smooth curve gets a corner
    /// at that time. An example is the path of a ball that bounces.
    pub time: Real,
    /// Value of the property at this time. A point or a color uses x, y and z. An orbit uses x
    /// for the yaw and y for the pitch. A plain number uses x only.
    pub value: Vec3<Real>,
}

impl Keyframe {
    /// Returns a keyframe for a point or a color.
    ///
    /// ```
    /// use whitted::animation::Keyframe;
    /// use whitted::{real, vec3};
    ///
    /// let top = Keyframe::vector(real!(0.5), vec3!(0, 2, 0));
    /// assert_eq!(top.value.y, real!(2));
    /// ```
    pub const fn vector(time: Real, value: Vec3<Real>) -> Self {
        Self { time, value }
    }

    /// Returns a keyframe for an orbit, with angles in degrees.
    pub const fn angles(time: Real, yaw_deg: Real, pitch_deg: Real) -> Self {
        Self::vector(time, Vec3::new(yaw_deg, pitch_deg, Real::ZERO))
    }

    /// Returns a keyframe for a plain number.
    pub const fn number(time: Real, number: Real) -> Self {
        Self::vector(time, Vec3::new(number, Real::ZERO, Real::ZERO))
    }
}

impl Fields for Keyframe {
    fn visit(&mut self, archive: &mut impl Archive) {
        archive::fixed(&mut self.time, archive);
        archive::vector(&mut self.value, archive);
    }
}

/// Method of interpolation between keyframes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Interpolation {
    /// Linear interpolation. The speed changes abruptly at keyframes.
    #[default]
    Linear,
    /// Cubic spline through the keyframes with continuous speed (Catmull and Rom 1974).
    ///
    /// The slope at a keyframe is the slope of a parabola through this keyframe and its two
    /// neighbors (Overhauser 1968). The method works for any spacing of the keyframes in time.
    /// The first and last segments of the spline are parabolas. Three keyframes therefore give
    /// a single parabola, such as the path of a thrown object.
    ///
    /// In a repeating animation, the curve can also be smooth at the time where the animation
    /// starts over. For this, the first keyframe must be at time 0 and the last at `duration`,
    /// and their values must be equal.
    Smooth,
}
