use crate::math::{Real, Rotation, Unit, Vec3, direction};

/// A pinhole camera.
///
/// ```
/// use whitted::{Camera, Vec3, real, vec3};
///
/// // A camera at eye level that looks at the origin, with the lens of a portrait.
/// let upright = Camera::new(vec3!(0, 1.7, 8), vec3!(0, 0, 0), real!(30));
/// // The same camera, tilted to the right.
/// let tilted = Camera { up: vec3!(0.2, 1, 0), ..upright };
/// assert_eq!(upright.up, vec3!(0, 1, 0));
/// # assert_eq!(tilted.eye, upright.eye);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Camera {
    /// Position of the camera's pinhole.
    pub eye: Vec3<Real>,
    /// Point that appears in the center of the picture. The distance between this point and the
    /// eye does not matter.
    pub look_at: Vec3<Real>,
    /// Direction that points up in the picture. The vector may have any length, but must not be
    /// parallel to the line of sight.
    pub up: Vec3<Real>,
    /// Vertical field of view in degrees, from 1 to 170.
    pub fovy_deg: Real,
}

impl Camera {
    /// Returns an upright camera: its `up` is +y.
    pub const fn new(eye: Vec3<Real>, look_at: Vec3<Real>, fovy_deg: Real) -> Self {
        Self {
            eye,
            look_at,
            up: Vec3::new(Real::ZERO, Real::ONE, Real::ZERO),
            fovy_deg,
        }
    }

    /// Returns the camera with its eye moved along a sphere around `look_at`.
    ///
    /// Both angles are in degrees. `yaw_deg` moves the eye to the right, around the `up` vector.
    /// `pitch_deg` moves the eye up. The eye stops 1 degree before it is straight above or below
    /// `look_at`. If the eye is already straight above or below `look_at`, the camera does not
    /// change.
    ///
    /// The eye moves by exact angles if the angles are multiples of 90 degrees. The error of other
    /// angles is below 0.11 degrees. Each orbit changes the distance from `look_at` by at most a
    /// factor of 1 ± 2^-28, so repeated orbits do not drift visibly.
    ///
    /// ```
    /// use whitted::{Camera, Real, real, vec3};
    ///
    /// let camera = Camera::new(vec3!(0, 1, 8), vec3!(0, 1, 0), real!(33));
    /// let from_the_right = camera.orbited(real!(90), Real::ZERO);
    /// assert_eq!(from_the_right.eye, vec3!(8, 1, 0));
    /// ```
    pub fn orbited(self, yaw_deg: Real, pitch_deg: Real) -> Self {
        let offset = self.eye.zip(self.look_at, Real::saturating_sub);
        let up = direction(self.up.map(Real::to_bits));
        let view = direction(offset.map(Real::to_bits));
        let (Some(up), Some(view)) = (up, view) else {
            return self;
        };
        // `level` is horizontal. Seen from the eye, it points left. A positive rotation around
        // `level` therefore raises the eye.
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

/// Returns the rotation around `level` that raises the eye by `degrees`. The rotation is
/// limited so that it does not bring the eye closer than 1 degree to the poles, the points
/// straight above and below `look_at`.
fn pitch(view: Vec3<Unit>, up: Vec3<Unit>, level: Vec3<Unit>, degrees: Real) -> Rotation {
    const HALF: Real = Real::lit("180");
    /// An elevation of 89 degrees. It is a `const` so that its literals are parsed at compile time.
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

/// Rotates `v` around a unit axis (Rodrigues 1840). The result is rounded to Q32 and saturated:
/// `v cos + (axis × v) sin + axis (axis · v) (1 - cos)`.
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

/// Returns `x a + y b + z c` in Q32, rounded to nearest. Each product of a Q32 number and a Q30
/// number has Q62, so the sum is shifted to Q32.
///
/// This function is not inlined, because products of 128 bits take much code.
#[inline(never)]
fn dot([x, y, z]: [i128; 3], [a, b, c]: [i64; 3]) -> i128 {
    let sum = x * i128::from(a) + y * i128::from(b) + z * i128::from(c);
    (sum + (1 << 29)) >> 30
}
