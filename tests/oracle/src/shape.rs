//! Where a ray crosses a surface, and the surface's normal there.
//!
//! A query asks for t alone. One function, `Shape::crossings`, serves both
//! kinds of query: it hands each crossing within reach to a visitor, which
//! answers how far the ray still reaches. The nearest hit answers the
//! crossing's own t; a shadow ray leaves its reach as it is, or gives zero to
//! stop.
//!
//! A ray's start point lies on its surface, whatever its rounded coordinates
//! say. So a quadratic's constant term is taken as zero there, which leaves the
//! other root exactly, and a plane is not hit again at all.

use crate::Float;
use crate::ray::{Ray, Reach};
use crate::sphereflake::Sphereflake;
use crate::vec3::{Vec3, vec3};

/// A surface in its own coordinates, moved to its center or origin.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize))]
pub enum Shape<F> {
    Sphere {
        center: Vec3<F>,
        radius: F,
    },
    Ellipsoid {
        center: Vec3<F>,
        radii: Vec3<F>,
    },
    /// x² + z² = r², within `y` or endless.
    Cylinder {
        origin: Vec3<F>,
        radius: F,
        y: Option<[F; 2]>,
    },
    /// Radius `radius` at y = 0, apex at y = `height`; a double cone where `y`
    /// goes beyond the apex, and where it is endless.
    Cone {
        origin: Vec3<F>,
        radius: F,
        height: F,
        y: Option<[F; 2]>,
    },
    /// x² + z² = y, within `y` or endless.
    Paraboloid {
        origin: Vec3<F>,
        y: Option<[F; 2]>,
    },
    /// Through `point`, with a unit normal; `bounds` on the world's axes.
    Plane {
        normal: Vec3<F>,
        point: Vec3<F>,
        bounds: [Option<[F; 2]>; 3],
    },
    Sphereflake(Sphereflake<F>),
}

impl<F: Float> Shape<F> {
    /// Hands every crossing within reach to `visit`: its t and the center or
    /// origin of what it lies on. `start` is the center of the part of this
    /// shape that the ray starts on, if it does.
    #[inline]
    pub(crate) fn crossings(
        &self,
        ray: &Ray<F>,
        start: Option<&Vec3<F>>,
        reach: &mut Reach<F>,
        visit: &mut impl FnMut(F, Vec3<F>) -> F,
    ) {
        match *self {
            Shape::Sphere { center, radius } => {
                let to_center = center - ray.origin;
                let foot = to_center.dot(ray.direction);
                if start.is_some() {
                    return reach.offer(foot + foot, center, visit);
                }
                let outside = to_center.dot(to_center) - radius * radius;
                if foot < F::ZERO && outside > F::ZERO {
                    return;
                }
                let half2 = foot * foot - outside;
                if half2 < F::ZERO {
                    return;
                }
                let half = half2.sqrt();
                reach.offer(foot - half, center, visit);
                reach.offer(foot + half, center, visit);
            }
            Shape::Plane {
                normal,
                point,
                bounds,
            } => {
                if start.is_some() {
                    return;
                }
                let height = normal.dot(point - ray.origin);
                let sink = normal.dot(ray.direction);
                if (height < F::ZERO) != (sink < F::ZERO) {
                    return;
                }
                let t = height / sink;
                if reach.holds(t) && is_within(ray, t, &bounds) {
                    reach.offer(t, point, visit);
                }
            }
            Shape::Sphereflake(ref flake) => flake.crossings(ray, start, reach, visit),
            Shape::Ellipsoid { center: origin, .. }
            | Shape::Cylinder { origin, .. }
            | Shape::Cone { origin, .. }
            | Shape::Paraboloid { origin, .. } => {
                for t in self.quadric(ray, start.is_some()) {
                    reach.offer(t, origin, visit);
                }
            }
        }
    }

    /// The crossings of one of the other quadrics, as of [`roots`]. Apart, as
    /// spheres and planes would share their registers with it.
    #[inline(never)]
    fn quadric(&self, ray: &Ray<F>, on_surface: bool) -> [F; 2] {
        match *self {
            Shape::Ellipsoid { center, radii } => {
                let scale = vec3(F::ONE / radii.x, F::ONE / radii.y, F::ONE / radii.z);
                let o = (ray.origin - center).times(scale);
                let d = ray.direction.times(scale);
                roots(d.dot(d), o.dot(d), o.dot(o) - F::ONE, on_surface)
            }
            Shape::Cylinder { origin, radius, y } => {
                let (o, d) = (ray.origin - origin, ray.direction);
                let a = d.x * d.x + d.z * d.z;
                let b = o.x * d.x + o.z * d.z;
                let c = o.x * o.x + o.z * o.z - radius * radius;
                between(o.y, d.y, y, roots(a, b, c, on_surface))
            }
            Shape::Cone {
                origin,
                radius,
                height,
                y,
            } => {
                let (o, d) = (ray.origin - origin, ray.direction);
                let slope = radius / height;
                let slope2 = slope * slope;
                let below_apex = o.y - height;
                let a = d.x * d.x + d.z * d.z - slope2 * d.y * d.y;
                let b = o.x * d.x + o.z * d.z - slope2 * below_apex * d.y;
                let c = o.x * o.x + o.z * o.z - slope2 * below_apex * below_apex;
                between(o.y, d.y, y, roots(a, b, c, on_surface))
            }
            Shape::Paraboloid { origin, y } => {
                let (o, d) = (ray.origin - origin, ray.direction);
                let a = d.x * d.x + d.z * d.z;
                let b = o.x * d.x + o.z * d.z - F::lit(0.5) * d.y;
                let c = o.x * o.x + o.z * o.z - o.y;
                between(o.y, d.y, y, roots(a, b, c, on_surface))
            }
            _ => [F::INFINITY; 2],
        }
    }

    /// The unit gradient of the implicit function at a point of the surface,
    /// on the part that has this center or origin.
    ///
    /// Made a unit vector even where the radius is known: a point's rounding
    /// would else stretch the reflected ray, that its next hit, and so on,
    /// tenfold at each bounce inside a glass sphere.
    #[inline]
    pub(crate) fn normal(&self, point: Vec3<F>, center: Vec3<F>) -> Vec3<F> {
        let p = point - center;
        match *self {
            Shape::Ellipsoid { radii: r, .. } => {
                vec3(p.x / (r.x * r.x), p.y / (r.y * r.y), p.z / (r.z * r.z)).unit()
            }
            Shape::Cylinder { .. } => vec3(p.x, F::ZERO, p.z).unit(),
            Shape::Cone { radius, height, .. } => {
                let slope = radius / height;
                vec3(p.x, slope * slope * (height - p.y), p.z).unit()
            }
            Shape::Paraboloid { .. } => vec3(p.x, F::lit(-0.5), p.z).unit(),
            Shape::Plane { normal, .. } => normal,
            Shape::Sphere { .. } | Shape::Sphereflake(_) => p.unit(),
        }
    }

    /// Whether the surface has an inside. A clamped one has none, so light goes
    /// straight on through it.
    pub(crate) fn has_inside(&self) -> bool {
        match self {
            Shape::Sphere { .. } | Shape::Ellipsoid { .. } | Shape::Sphereflake(_) => true,
            Shape::Cylinder { y, .. } | Shape::Cone { y, .. } | Shape::Paraboloid { y, .. } => {
                y.is_none()
            }
            Shape::Plane { bounds, .. } => bounds.iter().all(Option::is_none),
        }
    }
}

/// The roots of `a·t² + 2·b·t + c`, in no order. One that does not exist is not
/// a number or infinite, and so never within reach. From a start point on the
/// surface, where c = 0, the root t = 0 is left out.
fn roots<F: Float>(a: F, b: F, c: F, on_surface: bool) -> [F; 2] {
    let none = F::INFINITY;
    if on_surface {
        return [-(b + b) / a, none];
    }
    let discriminant = b * b - a * c;
    if discriminant < F::ZERO {
        return [none, none];
    }
    // The sum that cannot cancel gives one root, their product c/a the other.
    // It also holds for a = 0, a ray along a cone's side or a paraboloid's axis.
    let root = discriminant.sqrt();
    let sum = if b < F::ZERO { root - b } else { -root - b };
    [sum / a, c / sum]
}

/// Leaves out the roots at which the ray is not within the limits of y.
fn between<F: Float>(o: F, d: F, limits: Option<[F; 2]>, roots: [F; 2]) -> [F; 2] {
    roots.map(|t| {
        if is_between(o + t * d, limits) {
            t
        } else {
            F::INFINITY
        }
    })
}

fn is_between<F: Float>(x: F, limits: Option<[F; 2]>) -> bool {
    limits.is_none_or(|[low, high]| low < x && x < high)
}

fn is_within<F: Float>(ray: &Ray<F>, t: F, bounds: &[Option<[F; 2]>; 3]) -> bool {
    let [x, y, z] = *bounds;
    let (o, d) = (ray.origin, ray.direction);
    is_between(o.x + t * d.x, x) && is_between(o.y + t * d.y, y) && is_between(o.z + t * d.z, z)
}
