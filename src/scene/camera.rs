use crate::math::{Real, Rotation, Unit, Vec3, direction};

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

    /// The camera with its eye moved around `look_at`, by angles in degrees:
    /// `yaw_deg` to its right, around `up`; `pitch_deg` up, to 1 degree short of
    /// straight above or below.
    ///
    /// Angles are exact at multiples of 90 degrees, else to 0.11 degrees; the
    /// distance from `look_at` is kept to 2^-28 of itself, so it does no harm
    /// to orbit from where the last orbit led. An eye straight above or below
    /// stays there.
    ///
    /// ```
    /// use whitted::{Camera, Real, Vec3};
    ///
    /// let camera = Camera::new(Vec3::lit("0", "1", "8"), Vec3::lit("0", "1", "0"), Real::lit("33"));
    /// let from_the_right = camera.orbited(Real::lit("90"), Real::ZERO);
    /// assert_eq!(from_the_right.eye, Vec3::lit("8", "1", "0"));
    /// ```
    #[inline(never)]
    pub fn orbited(self, yaw_deg: Real, pitch_deg: Real) -> Self {
        let way = self.eye.zip(self.look_at, Real::saturating_sub);
        let up = direction(self.up.map(Real::to_bits));
        let view = direction(way.map(Real::to_bits));
        let (Some(up), Some(view)) = (up, view) else {
            return self;
        };
        // To the left as seen from the eye: around it, the eye rises.
        let Some(level) = direction(view.cross(up)) else {
            return self;
        };
        let pitch = pitch(view, up, level, pitch_deg);
        let way = turned(way, level, pitch);
        let way = turned(way, up, Rotation::by(yaw_deg));
        Self {
            eye: self.look_at.zip(way, Real::saturating_add),
            ..self
        }
    }
}

/// How far the way from `look_at` to the eye is to be raised, around `level`.
#[inline(never)]
fn pitch(view: Vec3<Unit>, up: Vec3<Unit>, level: Vec3<Unit>, degrees: Real) -> Rotation {
    const HALF: Real = Real::lit("180");
    /// By 89 degrees; a constant, or the text would be read by the chip.
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

/// A vector, turned around an axis (Rodrigues 1840):
/// `v cos + (axis × v) sin + axis (axis · v) (1 - cos)`.
fn turned(v: Vec3<Real>, axis: Vec3<Unit>, turn: Rotation) -> Vec3<Real> {
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

/// A sum of products, Q32 * Q30 -> Q62, rounded to Q32. Not inlined: products of
/// 128 bits are long.
#[inline(never)]
fn dot([x, y, z]: [i128; 3], [a, b, c]: [i64; 3]) -> i128 {
    let sum = x * i128::from(a) + y * i128::from(b) + z * i128::from(c);
    (sum + (1 << 29)) >> 30
}
