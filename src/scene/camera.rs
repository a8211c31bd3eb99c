use crate::math::{Real, Rotation, Unit, Vec3, direction};

/// Pinhole camera.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Camera {
    /// Position of the pinhole.
    pub eye: Vec3<Real>,
    /// Point in the center of the picture. Its distance from the eye does not matter.
    pub look_at: Vec3<Real>,
    /// Direction that points up in the picture, of any length and not parallel to the line of
    /// sight.
    pub up: Vec3<Real>,
    /// Vertical field of view in degrees, 1 to 170.
    pub fovy_deg: Real,
}

impl Camera {
    /// Returns an upright camera: `up` is +y.
    pub const fn new(eye: Vec3<Real>, look_at: Vec3<Real>, fovy_deg: Real) -> Self {
        Self {
            eye,
            look_at,
            up: Vec3::new(Real::ZERO, Real::ONE, Real::ZERO),
            fovy_deg,
        }
    }

    /// Returns the camera with its eye moved on a sphere around `look_at`.
    ///
    /// `yaw_deg` moves the eye to its right around `up`, `pitch_deg` moves it up, both in
    /// degrees. Pitch stops 1 degree short of straight above or below `look_at`.
    ///
    /// Angles are exact at multiples of 90 degrees and within 0.11 degrees elsewhere. The
    /// distance from `look_at` changes by at most a factor of 1 ± 2^-28, so repeated orbits do
    /// not drift visibly. An eye straight above or below `look_at` does not move.
    ///
    /// ```
    /// use whitted::{Camera, Real, Vec3};
    ///
    /// let camera = Camera::new(Vec3::lit("0", "1", "8"), Vec3::lit("0", "1", "0"), Real::lit("33"));
    /// let from_the_right = camera.orbited(Real::lit("90"), Real::ZERO);
    /// assert_eq!(from_the_right.eye, Vec3::lit("8", "1", "0"));
    /// ```
    pub fn orbited(self, yaw_deg: Real, pitch_deg: Real) -> Self {
        let offset = self.eye.zip(self.look_at, Real::saturating_sub);
        let up = direction(self.up.map(Real::to_bits));
        let view = direction(offset.map(Real::to_bits));
        let (Some(up), Some(view)) = (up, view) else {
            return self;
        };
        // Points left as seen from the eye, so a positive rotation around it raises the eye.
        let Some(level) = direction(view.cross(up)) else {
            return self;
        };
        let pitch = pitch(view, up, level, pitch_deg);
        let offset = rotate(offset, level, pitch);
        let offset = rotate(offset, up, Rotation::by(yaw_deg));
        Self {
            eye: self.look_at.zip(offset, Real::saturating_add),
            ..self
        }
    }
}

/// Returns the rotation around `level` that raises the eye by `degrees`, limited so that the eye
/// stays 1 degree short of the poles.
fn pitch(view: Vec3<Unit>, up: Vec3<Unit>, level: Vec3<Unit>, degrees: Real) -> Rotation {
    const HALF: Real = Real::lit("180");
    /// Elevation of 89 degrees. A `const`, so that the literals are parsed at compile time.
    const STEEPEST: Rotation = Rotation {
        cos: Unit::lit("0.0174524064"),
        sin: Unit::lit("0.9998476952"),
    };
    let ahead = direction(up.cross(level)).unwrap_or(view);
    let elevation = Rotation {
        cos: view.cosine(ahead),
        sin: view.cosine(up),
    };
    let turn = Rotation::by(degrees.clamp(-HALF, HALF));
    if elevation.then(turn).cos >= STEEPEST.cos.min(elevation.cos) {
        return turn;
    }
    let limit = if degrees < 0 {
        STEEPEST.back()
    } else {
        STEEPEST
    };
    limit.then(elevation.back())
}

/// Rotates `v` around a unit axis (Rodrigues 1840):
/// `v cos + (axis × v) sin + axis (axis · v) (1 - cos)`, rounded to Q32 and saturated.
fn rotate(v: Vec3<Real>, axis: Vec3<Unit>, turn: Rotation) -> Vec3<Real> {
    let v = v.map(|c| i128::from(c.to_bits()));
    let Vec3 { x, y, z } = axis.map(|c| i64::from(c.to_bits()));
    let [cos, sin] = [turn.cos, turn.sin].map(|c| i64::from(c.to_bits()));
    let across = Vec3::new([0, -z, y], [z, 0, -x], [-y, x, 0]).map(|row| dot([v.x, v.y, v.z], row));
    let along = dot([v.x, v.y, v.z], [x, y, z]);
    let kept = dot([along, 0, 0], [(1 << 30) - cos, 0, 0]);
    v.zip(across, |v, across| (v, across))
        .zip(Vec3::new(x, y, z), |(v, across), axis| {
            let sum = dot([v, across, kept], [cos, sin, axis]);
            Real::from_bits(sum.clamp(i64::MIN.into(), i64::MAX.into()) as i64)
        })
}

/// Returns `x a + y b + z c` in Q32, rounded to nearest: Q32 * Q30 -> Q62 -> Q32.
///
/// Out of line, because products of 128 bits take much code.
#[inline(never)]
fn dot([x, y, z]: [i128; 3], [a, b, c]: [i64; 3]) -> i128 {
    let sum = x * i128::from(a) + y * i128::from(b) + z * i128::from(c);
    (sum + (1 << 29)) >> 30
}
