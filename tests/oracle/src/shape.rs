//! Intersection of rays with shapes, and surface normals.
//!
//! `Shape::crossings` serves closest-hit and shadow rays. It passes every crossing in
//! an interval of t to a visitor, which returns the new far end of the interval. The
//! closest-hit search returns the crossing's t; a shadow ray keeps the far end, or
//! returns 0 to stop.
//!
//! A secondary ray starts on a surface, although its rounded coordinates may be off.
//! Quadratic equations therefore set the constant term to 0 for that surface, which
//! leaves the other root, and a plane cannot be hit again.

use crate::Float;
use crate::ray::{Interval, Ray};
use crate::sphereflake::Sphereflake;
use crate::vec3::{Vec3, vec3};

/// Surface, with its equation relative to its center or origin.
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
    /// x² + z² = r², clipped to the range `y` or unbounded.
    Cylinder {
        origin: Vec3<F>,
        radius: F,
        y: Option<[F; 2]>,
    },
    /// Cone of radius `radius` at y = 0 with its apex at y = `height`. A double cone if
    /// unbounded or if the range `y` extends beyond the apex.
    Cone {
        origin: Vec3<F>,
        radius: F,
        height: F,
        y: Option<[F; 2]>,
    },
    /// x² + z² = y, clipped to the range `y` or unbounded.
    Paraboloid {
        origin: Vec3<F>,
        y: Option<[F; 2]>,
    },
    /// Plane through `point` with a unit normal, clipped to `bounds` on the world axes.
    Plane {
        normal: Vec3<F>,
        point: Vec3<F>,
        bounds: [Option<[F; 2]>; 3],
    },
    Sphereflake(Sphereflake<F>),
}

impl<F: Float> Shape<F> {
    /// Passes every crossing in the interval to `visit`, with its t and the center or
    /// origin of its part. `start` is the center of the part on which the ray starts,
    /// if that belongs to this shape.
    #[inline]
    pub(crate) fn crossings(
        &self,
        ray: &Ray<F>,
        start: Option<&Vec3<F>>,
        interval: &mut Interval<F>,
        visit: &mut impl FnMut(F, Vec3<F>) -> F,
    ) {
        match *self {
            Shape::Sphere { center, radius } => {
                let to_center = center - ray.origin;
                let foot = to_center.dot(ray.direction);
                if start.is_some() {
                    return interval.report(foot + foot, center, visit);
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
                interval.report(foot - half, center, visit);
                interval.report(foot + half, center, visit);
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
                if interval.contains(t) && is_inside_bounds(ray, t, &bounds) {
                    interval.report(t, point, visit);
                }
            }
            Shape::Sphereflake(ref flake) => flake.crossings(ray, start, interval, visit),
            Shape::Ellipsoid { center: origin, .. }
            | Shape::Cylinder { origin, .. }
            | Shape::Cone { origin, .. }
            | Shape::Paraboloid { origin, .. } => {
                for t in self.quadric_roots(ray, start.is_some()) {
                    interval.report(t, origin, visit);
                }
            }
        }
    }

    /// Returns the crossings of an ellipsoid, cylinder, cone or paraboloid, in the form
    /// of [`roots`]. Out of line, to keep the registers for spheres and planes.
    #[inline(never)]
    fn quadric_roots(&self, ray: &Ray<F>, on_surface: bool) -> [F; 2] {
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
                clip_roots(o.y, d.y, y, roots(a, b, c, on_surface))
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
                clip_roots(o.y, d.y, y, roots(a, b, c, on_surface))
            }
            Shape::Paraboloid { origin, y } => {
                let (o, d) = (ray.origin - origin, ray.direction);
                let a = d.x * d.x + d.z * d.z;
                let b = o.x * d.x + o.z * d.z - F::lit(0.5) * d.y;
                let c = o.x * o.x + o.z * o.z - o.y;
                clip_roots(o.y, d.y, y, roots(a, b, c, on_surface))
            }
            _ => [F::INFINITY; 2],
        }
    }

    /// Returns the unit normal at a point of the part with this center or origin.
    ///
    /// Spheres normalize too, instead of dividing by the radius. Otherwise the rounding
    /// of the point would change the length of the reflected direction, and the error
    /// would grow tenfold at each bounce inside a glass sphere.
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

    /// Returns true if the surface has an interior. Clipped surfaces have none, and
    /// transmit light without refraction.
    pub(crate) fn has_interior(&self) -> bool {
        match self {
            Shape::Sphere { .. } | Shape::Ellipsoid { .. } | Shape::Sphereflake(_) => true,
            Shape::Cylinder { y, .. } | Shape::Cone { y, .. } | Shape::Paraboloid { y, .. } => {
                y.is_none()
            }
            Shape::Plane { bounds, .. } => bounds.iter().all(Option::is_none),
        }
    }
}

/// Returns the roots of `a·t² + 2·b·t + c`, unordered. A missing root is NaN or
/// infinite, and thus outside every interval. For a ray that starts on the surface, c
/// is 0 and the root t = 0 is left out.
fn roots<F: Float>(a: F, b: F, c: F, on_surface: bool) -> [F; 2] {
    let none = F::INFINITY;
    if on_surface {
        return [-(b + b) / a, none];
    }
    let discriminant = b * b - a * c;
    if discriminant < F::ZERO {
        return [none, none];
    }
    // The sum without cancellation gives one root, the product of roots c/a the other.
    // a is 0 for a ray along a cone's side or a paraboloid's axis; then c/sum is the
    // only finite root.
    let root = discriminant.sqrt();
    let sum = if b < F::ZERO { root - b } else { -root - b };
    [sum / a, c / sum]
}

/// Replaces roots at which y is outside its limits by infinity.
fn clip_roots<F: Float>(o: F, d: F, limits: Option<[F; 2]>, roots: [F; 2]) -> [F; 2] {
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

fn is_inside_bounds<F: Float>(ray: &Ray<F>, t: F, bounds: &[Option<[F; 2]>; 3]) -> bool {
    let [x, y, z] = *bounds;
    let (o, d) = (ray.origin, ray.direction);
    is_between(o.x + t * d.x, x) && is_between(o.y + t * d.y, y) && is_between(o.z + t * d.z, z)
}
