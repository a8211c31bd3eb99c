//! The scale of a scene.

use crate::num::{Length, Real, Unit, inverse_length};
use crate::prepared::OFFSET_BITS;
use crate::scene::Shape;
use crate::vector::normalize;
use crate::{Problem, Scene, Vec3};

/// Where a prepared scene lies in the world: `prepared = (world - center) * 2^exponent`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    /// In the bits of a [`Real`].
    pub(super) center: Vec3<i64>,
    pub(super) exponent: i32,
}

/// A box around points, in the bits of a [`Real`].
#[derive(Clone, Copy)]
struct Extent {
    low: Vec3<i64>,
    high: Vec3<i64>,
}

impl Extent {
    fn add(&mut self, point: Vec3<Real>, reach: Real) {
        let (point, reach) = (point.map(Real::to_bits), reach.to_bits());
        self.low = self.low.zip(point, |low, p| low.min(p - reach));
        self.high = self.high.zip(point, |high, p| high.max(p + reach));
    }
}

/// How many bits a number has.
fn bits(x: i64) -> i32 {
    64 - x.unsigned_abs().leading_zeros() as i32
}

impl Frame {
    /// Fits the finite geometry, the eye and the lights within ±1, and the
    /// bounds of planes within ±4. Endless planes have no say.
    pub(super) fn new(scene: &Scene<'_>) -> Self {
        let eye = scene.camera.eye.map(Real::to_bits);
        let mut extent = Extent {
            low: eye,
            high: eye,
        };
        for light in scene.lights {
            extent.add(light.position, Real::ZERO);
        }
        for object in scene.objects {
            if let Shape::Sphere { center, radius } = object.shape {
                extent.add(center, radius);
            }
        }
        let center = extent.low.zip(extent.high, |low, high| (low + high) / 2);
        let half = extent.high.zip(center, |high, center| high - center + 1);
        let mut exponent = 32 - bits(half.x.max(half.y).max(half.z));
        for object in scene.objects {
            let Shape::Plane { bounds, point, .. } = object.shape else {
                continue;
            };
            let bounds = [
                (bounds.x, center.x),
                (bounds.y, center.y),
                (bounds.z, center.z),
            ];
            for (bound, center) in bounds {
                for end in bound.into_iter().flatten() {
                    exponent = exponent.min(34 - bits(end.to_bits() - center));
                }
            }
            // Where there is nothing but an eye, a plane has its say after all.
            if extent.low == extent.high {
                let way = point.map(Real::to_bits).zip(center, |p, c| p - c);
                exponent = exponent.min(33 - bits(way.x).max(bits(way.y)).max(bits(way.z)));
            }
        }
        Self {
            center,
            exponent: exponent.min(FINEST),
        }
    }

    /// A distance, from the bits of a [`Real`] to those of a [`Length`], rounded.
    pub(super) fn length(&self, bits: i64) -> i64 {
        shifted(bits.into(), self.exponent - 4) as i64
    }

    pub(super) fn point(&self, point: Vec3<Real>) -> Vec3<Length> {
        point.zip(self.center, |p, c| {
            Length::from_bits(self.length(p.to_bits() - c) as i32)
        })
    }

    /// `normal · point`, in the bits of a [`Length`]; `None` if it is beyond
    /// what far points can reach.
    pub(super) fn offset(&self, normal: Vec3<Unit>, point: Vec3<Real>) -> Option<i64> {
        let way = point.zip(self.center, |p, c| i128::from(p.to_bits() - c));
        let along = way.zip(normal, |w, n| w * i128::from(n.to_bits()));
        let offset = shifted(along.x + along.y + along.z, self.exponent - 34);
        (offset.abs() < 1 << OFFSET_BITS).then_some(offset as i64)
    }

    /// What to say of a plane that is too far away.
    pub(super) fn reach_problem(&self) -> Problem {
        let most = Real::from_bits(1 << (OFFSET_BITS + 4 - self.exponent).clamp(0, 62));
        Problem::OutOfRange { least: -most, most }
    }

    /// The world size of 2^10 steps.
    pub(super) fn smallest(&self) -> Real {
        Real::from_bits(1 << (14 - self.exponent).clamp(0, 62))
    }
}

/// The finest scale: a step of a [`Real`] is then one of a [`Length`].
const FINEST: i32 = 4;

/// `x * 2^shift`, rounded.
fn shifted(x: i128, shift: i32) -> i128 {
    if shift >= 0 {
        x << shift
    } else {
        (x + (1 << (-shift - 1))) >> -shift
    }
}

/// The cross product, exact: `I2F30^2 -> I4F60`.
pub(super) fn cross(a: Vec3<Unit>, b: Vec3<Unit>) -> Vec3<i64> {
    let minor = |p: Unit, q: Unit, r: Unit, s: Unit| (p.wide_mul(q) - r.wide_mul(s)).to_bits();
    Vec3::new(
        minor(a.y, b.z, a.z, b.y),
        minor(a.z, b.x, a.x, b.z),
        minor(a.x, b.y, a.y, b.x),
    )
}

/// The unit vector along a vector of any step; `None` if it is shorter than
/// 2^10 steps.
pub(super) fn direction(v: Vec3<i64>) -> Option<Vec3<Unit>> {
    let most = bits(v.x).max(bits(v.y)).max(bits(v.z));
    if most <= 10 {
        return None;
    }
    let v = v.map(|c| shifted(c.into(), 30 - most) as i32);
    let square = v.map(|c| i64::from(c) * i64::from(c));
    let inverse = inverse_length((square.x + square.y + square.z) as u64);
    Some(normalize(v, inverse).renormalized())
}
