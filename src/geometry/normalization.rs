//! The scale of a scene.

use fixed::types::U0F32;

use crate::geometry::{NEAR, Sphereflake};
use crate::math::{Length, Real, Unit, Vec3, bits, square_root};
use crate::scene::{Scene, SceneProblem, Shape};

/// Offsets of planes are below 2^48 steps, 2^20 times the finite geometry.
pub(crate) const OFFSET_BITS: i32 = 48;

/// The finest scale: a step of a [`Real`](crate::Real) is then one of a [`Length`].
pub(crate) const FINEST: i32 = 4;

/// Where a prepared scene lies in the world: `prepared = (world - center) * 2^exponent`.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Normalization {
    /// In the bits of a [`Real`](crate::Real).
    pub(crate) center: Vec3<i64>,
    /// -32 to [`FINEST`].
    pub(crate) exponent: i32,
}

/// A box around points, in the bits of a [`Real`].
#[derive(Clone, Copy)]
struct Extent {
    low: Vec3<i64>,
    high: Vec3<i64>,
}

impl Extent {
    /// Adds the box of `reach` around a point.
    fn add(&mut self, point: Vec3<Real>, reach: Vec3<i64>) {
        let point = point.map(Real::to_bits);
        self.add_point(point.zip(reach, |p, r| p - r));
        self.add_point(point.zip(reach, |p, r| p + r));
    }

    fn add_point(&mut self, point: Vec3<i64>) {
        self.low = self.low.zip(point, i64::min);
        self.high = self.high.zip(point, i64::max);
    }

    /// Adds what of a shape is finite.
    fn add_shape(&mut self, shape: &Shape) {
        let around = |reach: i64| Vec3::new(reach, reach, reach);
        match *shape {
            Shape::Sphere { center, radius } => self.add(center, around(radius.to_bits())),
            Shape::Ellipsoid { center, radii } => self.add(center, radii.map(Real::to_bits)),
            Shape::Cylinder {
                origin,
                radius,
                y: Some(y),
            } => self.add_rings(origin, y, [radius.to_bits(); 2]),
            // As high as all else is.
            Shape::Cylinder {
                origin,
                radius,
                y: None,
            } => {
                let origin = Vec3 {
                    y: Real::from_bits(self.low.y),
                    ..origin
                };
                self.add_rings(origin, [Real::ZERO; 2], [radius.to_bits(); 2]);
            }
            Shape::Cone {
                origin,
                radius,
                height,
                y,
            } => {
                let y = y.unwrap_or([Real::ZERO, height]);
                let radii = y.map(|y| cone_radius(radius, height, y).abs());
                self.add_rings(origin, y, radii);
            }
            Shape::Paraboloid { origin, y } => {
                let y = paraboloid_ends(y);
                self.add_rings(origin, y, y.map(|y| root(y.max(Real::ZERO))));
            }
            Shape::Sphereflake {
                center,
                radius,
                depth,
                ratio,
                ..
            } => {
                let bound = Sphereflake::bound(below_one(ratio), depth);
                let reach = i128::from(radius.to_bits()) * i128::from(bound.to_bits());
                self.add(center, around((reach >> 29) as i64 + 1));
            }
            Shape::Plane { .. } => {}
        }
    }

    /// Adds circles around the y axis through a point.
    fn add_rings(&mut self, origin: Vec3<Real>, y: [Real; 2], radii: [i64; 2]) {
        for (y, radius) in y.into_iter().zip(radii) {
            let center = Vec3 {
                y: origin.y + y,
                ..origin
            };
            self.add(center, Vec3::new(radius, 0, radius));
        }
    }
}

/// The fraction of a number.
pub(crate) fn below_one(x: Real) -> U0F32 {
    U0F32::from_bits(x.to_bits() as u32)
}

/// Where a paraboloid ends that is told to end so: below its vertex there is
/// nothing to bound, but for what keeps the vertex whole.
pub(crate) fn paraboloid_ends([low, high]: [Real; 2]) -> [Real; 2] {
    [low.max(-(high >> 10_u32)), high]
}

/// The radius of a cone at a height, below 0 beyond the apex, in the bits of a
/// [`Real`]; it must fit.
pub(crate) fn cone_radius(radius: Real, height: Real, y: Real) -> i64 {
    let product = i128::from(radius.to_bits()) * i128::from((height - y).to_bits());
    product.checked_div(height.to_bits().into()).unwrap_or(0) as i64
}

/// The root of a number from 0, rounded up: Q32 -> Q40 -> Q20 -> Q32.
fn root(x: Real) -> i64 {
    (i64::from(square_root((x.to_bits() as u64) << 8)) + 1) << 12
}

impl Normalization {
    /// Fits the finite geometry, the eye and the lights within ±1, and the
    /// bounds of planes within ±4. Endless planes have no say.
    pub(crate) fn new(scene: &Scene<'_>) -> Self {
        let eye = scene.camera.eye.map(Real::to_bits);
        let mut extent = Extent {
            low: eye,
            high: eye,
        };
        for light in scene.lights {
            extent.add_point(light.position.map(Real::to_bits));
        }
        for object in scene.objects {
            extent.add_shape(&object.shape);
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
    pub(crate) fn length(&self, bits: i64) -> i64 {
        shifted(bits.into(), self.exponent - 4) as i64
    }

    /// A size, rounded.
    pub(crate) fn size(&self, size: Real) -> Length {
        Length::from_bits(self.length(size.to_bits()) as i32)
    }

    /// Half of a size that is given in the bits of a [`Real`], rounded.
    pub(crate) fn half_size(&self, bits: i64) -> Length {
        Length::from_bits(shifted(bits.into(), self.exponent - 5) as i32)
    }

    /// A size below 1, rounded.
    pub(crate) fn fraction(&self, size: Real) -> U0F32 {
        let bits = shifted(size.to_bits().into(), self.exponent);
        U0F32::from_bits(bits.min(u32::MAX.into()) as u32)
    }

    /// A square world unit, from the bits of a [`Real`] to steps of 2^-56, rounded.
    pub(crate) fn square(&self, bits: i64) -> i64 {
        shifted(bits.into(), 24 + 2 * self.exponent) as i64
    }

    pub(crate) fn point(&self, point: Vec3<Real>) -> Vec3<Length> {
        point.zip(self.center, |p, c| {
            Length::from_bits(self.length(p.to_bits() - c) as i32)
        })
    }

    /// Whether rays may start at a point: [`NEAR`] is 3.5 times as far as all
    /// that the scale was found for.
    pub(crate) fn is_near(&self, point: Vec3<Real>) -> bool {
        let way = point.zip(self.center, |p, c| self.length(p.to_bits() - c));
        way.all(|c| c.abs() <= i64::from(NEAR))
    }

    /// `normal · point`, in the bits of a [`Length`]; `None` if it is beyond
    /// what far points can reach.
    pub(crate) fn offset(&self, normal: Vec3<Unit>, point: Vec3<Real>) -> Option<i64> {
        let way = point.zip(self.center, |p, c| i128::from(p.to_bits() - c));
        let along = way.zip(normal, |w, n| w * i128::from(n.to_bits()));
        let offset = shifted(along.x + along.y + along.z, self.exponent - 34);
        (offset.abs() < 1 << OFFSET_BITS).then_some(offset as i64)
    }

    /// What to say of a plane that is too far away.
    pub(crate) fn reach_problem(&self) -> SceneProblem {
        let most = Real::from_bits(1 << (OFFSET_BITS + 4 - self.exponent).clamp(0, 62));
        SceneProblem::OutOfRange { least: -most, most }
    }

    /// The world size of 2^10 steps.
    pub(crate) fn smallest(&self) -> Real {
        Real::from_bits(1 << (14 - self.exponent).clamp(0, 62))
    }
}

/// `x * 2^shift`, rounded.
fn shifted(x: i128, shift: i32) -> i128 {
    if shift >= 0 {
        x << shift
    } else {
        (x + (1 << (-shift - 1))) >> -shift
    }
}
