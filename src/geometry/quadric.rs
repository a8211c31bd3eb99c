//! Quadrics: ellipsoids, and cylinders, cones and paraboloids around the y axis.
//!
//! Each of these four kinds of quadric is called a form. A form provides the quadratic equation
//! for the hits of a ray, and the gradient at a point. The code that all forms share is in this
//! file.

pub(super) mod cone;
pub(super) mod cylinder;
pub(super) mod ellipsoid;
mod error_bounds;
mod form;
pub(super) mod paraboloid;
mod placed;
mod quadratic;
mod ratio;

use super::bounding_sphere::BoundingSphere;
use super::point::{HORIZON, Point};
use super::primitive::{Primitive, PrimitivePart, SurfacePoint};
use super::ray::Ray;
use super::shadow_segment::ShadowSegment;
use super::surface::SurfaceFlags;
use super::valid;
use crate::archive;
use crate::archive::{Archive, Fields};
use crate::math::{Length, Product, SoftFloat, Square, Vec3, direction, round_length, square_root};
use crate::observer::{Observer, ShapeKind};
use cone::Cone;
use cylinder::Cylinder;
use ellipsoid::Ellipsoid;
use form::QuadricForm;
use paraboloid::Paraboloid;
pub(super) use placed::Placed;
use quadratic::Quadratic;

/// A quadric surface in the prepared scene.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Quadric {
    /// Origin of the form's coordinates, within ±1.
    center: Vec3<Length>,
    /// Lowest and highest y of the surface. `None` if y is not limited.
    clamp: Option<[Length; 2]>,
    form: Form,
}

#[derive(Clone, Copy, Debug)]
enum Form {
    Ellipsoid(Ellipsoid),
    Cylinder(Cylinder),
    Cone(Cone),
    Paraboloid(Paraboloid),
}

/// Evaluates an expression for any of the four forms of a quadric. All code that depends on the
/// form uses this macro.
macro_rules! dispatch {
    ($form:expr, $it:ident => $answer:expr) => {
        match $form {
            Form::Ellipsoid($it) => $answer,
            Form::Cylinder($it) => $answer,
            Form::Cone($it) => $answer,
            Form::Paraboloid($it) => $answer,
        }
    };
}

macro_rules! from_forms {
    ($($form:ident),*) => {$(
        impl From<Placed<$form>> for Quadric {
            fn from(Placed { center, clamp, form }: Placed<$form>) -> Self {
                Self {
                    center,
                    clamp,
                    form: Form::$form(form),
                }
            }
        }
    )*};
}

from_forms!(Ellipsoid, Cylinder, Cone, Paraboloid);

impl Default for Form {
    fn default() -> Self {
        Self::Cylinder(Cylinder::default())
    }
}

/// Upper bound of the distance between two points of the bounded geometry. Each coordinate of
/// these points is within ±1.
const FARTHEST: Length = Length::lit("3.5");

impl Quadric {
    /// Returns a placeholder quadric for a tag of a compiled scene, or `None` if the tag
    /// belongs to another shape. The decoder then reads the fields of the quadric.
    pub(super) fn of_tag(tag: u8) -> Option<Self> {
        let form = match tag {
            Ellipsoid::TAG => Form::Ellipsoid(Ellipsoid::default()),
            Cylinder::TAG => Form::Cylinder(Cylinder::default()),
            Cone::TAG => Form::Cone(Cone::default()),
            Paraboloid::TAG => Form::Paraboloid(Paraboloid::default()),
            _ => return None,
        };
        Some(Self {
            form,
            ..Self::default()
        })
    }

    /// Tag of the quadric in a compiled scene.
    pub(super) fn tag(&self) -> u8 {
        fn tag<F: QuadricForm>(_: &F) -> u8 {
            F::TAG
        }
        dispatch!(&self.form, form => tag(form))
    }

    /// Returns true if the quadric extends to infinity.
    fn is_unbounded(&self) -> bool {
        self.clamp.is_none() && self.tag() != Ellipsoid::TAG
    }

    /// Returns the distances from the origin of a ray to its hits, in no particular order. If
    /// the quadric is bounded, the origin must be in the near range (each coordinate within
    /// ±3.5).
    ///
    /// `side` is `None` if the ray does not start on this quadric. If it does, `side` is true
    /// for a ray through the inside and false for a ray on the outside. The origin is then one
    /// root of the quadratic equation, so the other root needs no square root.
    #[inline(never)]
    fn hits(&self, ray: &Ray, side: Option<bool>) -> [Option<SoftFloat>; 2] {
        let quadratic = self.quadratic(ray);
        let mut roots = match side {
            None => quadratic.roots(),
            Some(is_inside) => [quadratic.other_root(is_inside), None],
        };
        for root in &mut roots {
            if let Some(distance) = root {
                distance.exponent += i32::from(ray.origin.shift);
                if !self.contains(ray, *distance) {
                    *root = None;
                }
            }
        }
        roots
    }

    /// Returns the distance of the nearest hit.
    fn nearest(&self, ray: &Ray, is_origin: bool) -> Option<SoftFloat> {
        match self.hits(ray, is_origin.then_some(ray.leaves.is_inside)) {
            [Some(first), Some(second)] => Some(first.min(second)),
            [first, second] => first.or(second),
        }
    }

    fn quadratic(&self, ray: &Ray) -> Quadratic {
        let Point { shift, .. } = ray.origin;
        let offset = -ray.origin.to(self.center);
        dispatch!(&self.form, form => form.quadratic(offset, ray.direction, shift))
    }

    /// Returns true if the hit at a distance is within the `clamp` of this quadric. A quadric
    /// without a clamp accepts every hit that is before the horizon.
    #[inline(never)]
    fn contains(&self, ray: &Ray, distance: SoftFloat) -> bool {
        let Some([low, high]) = self.clamp else {
            return distance.exponent <= HORIZON;
        };
        distance.near().is_some_and(|distance| {
            let rise = round_length::<30>(ray.direction.y.product(distance).to_bits());
            let y = ray.origin.coordinates.y.saturating_add(rise);
            low <= y && y <= high
        })
    }
}

impl Primitive for Quadric {
    fn is_valid(&self) -> bool {
        let tag = self.tag();
        let is_clamp_right = match self.clamp {
            Some(_) => tag != Ellipsoid::TAG,
            None => tag != Paraboloid::TAG,
        };
        is_clamp_right
            && dispatch!(&self.form, form => form.is_valid())
            && valid::is_within_one(&self.center)
            && self
                .clamp
                .is_none_or(|ends| ends.into_iter().all(|y| valid::is_within(y, Length::ONE)))
    }

    fn kind(&self) -> ShapeKind {
        fn kind<F: QuadricForm>(_: &F) -> ShapeKind {
            F::KIND
        }
        dispatch!(&self.form, form => kind(form))
    }

    /// Returns the flags of the quadric. A clamped quadric has the flag for open surfaces,
    /// because it encloses no volume.
    fn flags(&self) -> SurfaceFlags {
        SurfaceFlags::NONE
            .with(SurfaceFlags::BOUNDED, !self.is_unbounded())
            .with(SurfaceFlags::OPEN, self.clamp.is_some())
    }

    fn bounding_sphere(&self) -> Option<BoundingSphere> {
        /// Larger than the sum of all rounding errors.
        const MARGIN: Length = Length::lit("0.000001");
        if self.is_unbounded() {
            return None;
        }
        let height = self.clamp.map_or(Length::ZERO, |[low, high]| {
            (high - self.center.y).max(self.center.y - low)
        });
        let width = dispatch!(&self.form, form => form.max_radius(height));
        let width = width.map_or(FARTHEST, |width| width.min(FARTHEST));
        let square = width.square() + height.square();
        let radius = Length::from_bits(square_root(square.to_bits() as u64) as i32);
        Some(BoundingSphere {
            center: self.center,
            radius: (radius + MARGIN).min(FARTHEST),
        })
    }

    #[inline(never)]
    fn intersect(
        &self,
        ray: &Ray,
        is_origin: bool,
        _: Length,
        _: &mut PrimitivePart,
        observer: &mut impl Observer,
    ) -> Option<Length> {
        let distance = self
            .nearest(ray, is_origin)
            .map(|distance| distance.near().unwrap_or(Length::MAX))
            .filter(|distance| is_origin || *distance > Length::ZERO);
        observer.test(self.kind(), distance.is_some());
        distance
    }

    fn intersect_extended(&self, ray: &Ray, is_origin: bool) -> Option<SoftFloat> {
        if self.is_unbounded() {
            self.nearest(ray, is_origin)
        } else {
            None
        }
    }

    /// Returns the normal at a hit point. At the apex of a cone, the result is the zero vector.
    #[inline(never)]
    fn surface_at(&self, point: &Point, _: &PrimitivePart) -> SurfacePoint {
        let offset = -point.to(self.center);
        let gradient = dispatch!(&self.form, form => form.gradient(offset, point.shift));
        SurfacePoint::new(direction(gradient).unwrap_or_default())
    }

    #[inline(always)]
    fn count_crossings(
        &self,
        _: &ShadowSegment<'_>,
        _: bool,
        _: bool,
        _: &mut impl Observer,
    ) -> Option<u8> {
        None
    }

    /// Visits the points where a shadow segment crosses the quadric. If the lit point is on
    /// this quadric, the ray is traced from the lit point to the light. The lit point is then a
    /// known root of the quadratic equation.
    fn visit_crossings(
        &self,
        segment: &ShadowSegment<'_>,
        is_origin: bool,
        observer: &mut impl Observer,
        visit: &mut dyn FnMut(Point) -> bool,
    ) {
        let mut ray = segment.to_ray();
        if is_origin {
            ray = Ray {
                origin: segment.ray.origin,
                direction: -ray.direction,
                leaves: segment.ray.leaves,
            };
        }
        let hits = self.hits(&ray, is_origin.then_some(ray.leaves.is_inside));
        let mut is_crossed = false;
        let mut visit = |point| {
            is_crossed = true;
            visit(point)
        };
        let mut hits = hits.into_iter().flatten();
        let _ = hits.all(|distance| segment.visit_at(&ray, distance, &mut visit));
        observer.test(self.kind(), is_crossed);
    }
}

impl Fields for Quadric {
    fn visit(&mut self, archive: &mut impl Archive) {
        archive::vector(&mut self.center, archive);
        let mut is_clamped = u8::from(self.clamp.is_some());
        is_clamped.visit(archive);
        let [mut low, mut high] = self.clamp.unwrap_or_default();
        archive::fixed(&mut low, archive);
        archive::fixed(&mut high, archive);
        self.clamp = (is_clamped != 0).then_some([low, high]);
        dispatch!(&mut self.form, form => form.visit(archive));
    }
}
