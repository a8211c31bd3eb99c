//! The prepared shapes of a scene. This file selects the code for each kind of shape.
//!
//! To add a shape, write a file that implements [`AuthoredShape`] and [`Primitive`], add the
//! authored form to `scene/shape.rs`, and add a line to each list in this file.

use super::bounding_sphere::BoundingSphere;
use super::extent::Extent;
#[cfg(not(all(feature = "quadrics", feature = "sphereflake")))]
use super::limits;
use super::normalization::Normalization;
use super::plane::{self, Plane};
use super::point::Point;
use super::primitive::{AuthoredShape, Primitive, PrimitivePart, SurfacePoint};
#[cfg(feature = "quadrics")]
use super::quadric::{Quadric, cone, cylinder, ellipsoid, paraboloid};
use super::ray::Ray;
use super::shadow_segment::ShadowSegment;
use super::sphere::{self, Sphere};
#[cfg(feature = "sphereflake")]
use super::sphereflake::{self, Sphereflake};
use super::surface::SurfaceFlags;
use crate::archive::{Archive, Fields};
use crate::math::{Length, SoftFloat, Vec3};
use crate::observer::{Observer, ShapeKind};
use crate::scene::{self, SceneError, SceneItem};

/// A shape in the prepared scene.
///
/// With `repr(u8)`, the tag of the enum has a byte of its own. Otherwise, the compiler would hide
/// the tag in a field of a variant, and reading it would take longer. The size of the enum is the
/// same.
#[derive(Clone, Copy, Debug)]
#[repr(u8)]
pub(crate) enum Shape {
    Sphere(Sphere),
    Plane(Plane),
    #[cfg(feature = "quadrics")]
    Quadric(Quadric),
    #[cfg(feature = "sphereflake")]
    Sphereflake(Sphereflake),
}

/// Evaluates `$answer`, where `$it` is the primitive inside a prepared shape.
macro_rules! dispatch {
    ($shape:expr, $it:ident => $answer:expr) => {
        match $shape {
            Shape::Sphere($it) => $answer,
            Shape::Plane($it) => $answer,
            #[cfg(feature = "quadrics")]
            Shape::Quadric($it) => $answer,
            #[cfg(feature = "sphereflake")]
            Shape::Sphereflake($it) => $answer,
        }
    };
}

/// Evaluates `$answer`, where `$it` is the authored form of a shape. If the shape needs a Cargo
/// feature that is off, evaluates `$missing` instead, where `$feature` is the name of that feature.
macro_rules! dispatch_authored {
    ($shape:expr, $it:ident => $answer:expr, $feature:ident => $missing:expr) => {
        match *$shape {
            scene::Shape::Sphere { center, radius } => {
                let $it = sphere::Authored { center, radius };
                $answer
            }
            scene::Shape::Plane {
                normal,
                point,
                bounds,
            } => {
                let $it = plane::authored::Authored {
                    normal,
                    point,
                    bounds,
                };
                $answer
            }
            #[cfg(feature = "quadrics")]
            scene::Shape::Ellipsoid { center, radii } => {
                let $it = ellipsoid::Authored { center, radii };
                $answer
            }
            #[cfg(feature = "quadrics")]
            scene::Shape::Cylinder { origin, radius, y } => {
                let $it = cylinder::Authored { origin, radius, y };
                $answer
            }
            #[cfg(feature = "quadrics")]
            scene::Shape::Cone {
                origin,
                radius,
                height,
                y,
            } => {
                let $it = cone::Authored {
                    origin,
                    radius,
                    height,
                    y,
                };
                $answer
            }
            #[cfg(feature = "quadrics")]
            scene::Shape::Paraboloid { origin, y } => {
                let $it = paraboloid::Authored { origin, y };
                $answer
            }
            #[cfg(feature = "sphereflake")]
            scene::Shape::Sphereflake {
                center,
                radius,
                depth,
                ratio,
                frame,
            } => {
                let $it = sphereflake::authored::Authored {
                    center,
                    radius,
                    depth,
                    ratio,
                    frame,
                };
                $answer
            }
            #[cfg(not(feature = "sphereflake"))]
            scene::Shape::Sphereflake { .. } => {
                let $feature = "sphereflake";
                $missing
            }
            #[cfg(not(feature = "quadrics"))]
            _ => {
                let $feature = "quadrics";
                $missing
            }
        }
    };
}

macro_rules! from_primitives {
    ($($feature:literal: $primitive:ident),*) => {$(
        #[cfg(feature = $feature)]
        impl From<$primitive> for Shape {
            fn from(it: $primitive) -> Self {
                Self::$primitive(it)
            }
        }
    )*};
}

impl From<Sphere> for Shape {
    fn from(it: Sphere) -> Self {
        Self::Sphere(it)
    }
}

impl From<Plane> for Shape {
    fn from(it: Plane) -> Self {
        Self::Plane(it)
    }
}

from_primitives!("quadrics": Quadric, "sphereflake": Sphereflake);

#[cfg(feature = "quadrics")]
impl<F> From<super::quadric::Placed<F>> for Shape
where
    Quadric: From<super::quadric::Placed<F>>,
{
    fn from(it: super::quadric::Placed<F>) -> Self {
        Self::Quadric(it.into())
    }
}

/// Checks every property of an authored shape that does not depend on the scale of the scene.
pub(crate) fn validate(shape: &scene::Shape, item: SceneItem) -> Result<(), SceneError> {
    dispatch_authored!(shape, it => it.validate(item), feature => {
        limits::error(item, "shape", scene::SceneProblem::MissingFeature(feature))
    })
}

/// Adds the bounded parts of an authored shape to the extent of the scene.
pub(crate) fn extend(shape: &scene::Shape, extent: &mut Extent) {
    dispatch_authored!(shape, it => it.extend(extent), _feature => ());
}

/// Returns the largest exponent of the scene's scale with which an authored shape can still be
/// prepared. The scale is a power of two.
pub(crate) fn max_exponent(shape: &scene::Shape, center: Vec3<i64>, is_alone: bool) -> i32 {
    dispatch_authored!(shape, it => it.max_exponent(center, is_alone), _feature => i32::MAX)
}

impl Shape {
    /// Prepares an authored shape.
    pub(crate) fn prepare(
        shape: &scene::Shape,
        normalization: &Normalization,
        item: SceneItem,
    ) -> Result<Self, SceneError> {
        dispatch_authored!(shape, it => it.prepare(normalization, item).map(Self::from), feature => {
            limits::error(item, "shape", scene::SceneProblem::MissingFeature(feature))
        })
    }

    /// Returns the plane, if the shape is one.
    #[inline(always)]
    pub(crate) fn as_plane(&self) -> Option<&Plane> {
        if let Self::Plane(plane) = self {
            Some(plane)
        } else {
            None
        }
    }

    /// See [`Primitive::is_valid`].
    pub(crate) fn is_valid(&self) -> bool {
        dispatch!(self, it => it.is_valid())
    }

    /// See [`Primitive::flags`].
    pub(crate) fn flags(&self) -> SurfaceFlags {
        dispatch!(self, it => it.flags())
    }

    /// See [`Primitive::bounding_sphere`].
    pub(crate) fn bounding_sphere(&self) -> Option<BoundingSphere> {
        dispatch!(self, it => it.bounding_sphere())
    }

    /// See [`Primitive::is_sphere`].
    pub(crate) fn is_sphere(&self) -> bool {
        dispatch!(self, it => it.is_sphere())
    }

    /// See [`Primitive::kind`].
    pub(crate) fn kind(&self) -> ShapeKind {
        dispatch!(self, it => it.kind())
    }

    /// See [`Primitive::is_near`].
    #[inline(always)]
    pub(crate) fn is_near(&self) -> bool {
        dispatch!(self, it => it.is_near())
    }

    /// See [`Primitive::intersect`].
    #[inline(always)]
    pub(crate) fn intersect(
        &self,
        ray: &Ray,
        is_origin: bool,
        limit: Length,
        part: &mut PrimitivePart,
        observer: &mut impl Observer,
    ) -> Option<Length> {
        dispatch!(self, it => it.intersect(ray, is_origin, limit, part, observer))
    }

    /// See [`Primitive::intersect_extended`].
    #[inline(never)]
    pub(crate) fn intersect_extended(&self, ray: &Ray, is_origin: bool) -> Option<SoftFloat> {
        dispatch!(self, it => it.intersect_extended(ray, is_origin))
    }

    /// See [`Primitive::covers`].
    pub(crate) fn covers(&self, point: &Point) -> bool {
        dispatch!(self, it => it.covers(point))
    }

    /// See [`Primitive::surface_at`].
    #[inline(always)]
    pub(crate) fn surface_at(&self, point: &Point, part: &PrimitivePart) -> SurfacePoint {
        dispatch!(self, it => it.surface_at(point, part))
    }

    /// See [`Primitive::count_crossings`].
    #[inline(always)]
    pub(crate) fn count_crossings(
        &self,
        segment: &ShadowSegment<'_>,
        is_origin: bool,
        any: bool,
        observer: &mut impl Observer,
    ) -> Option<u8> {
        dispatch!(self, it => it.count_crossings(segment, is_origin, any, observer))
    }

    /// See [`Primitive::visit_crossings`].
    #[inline(never)]
    pub(crate) fn visit_crossings(
        &self,
        segment: &ShadowSegment<'_>,
        is_origin: bool,
        observer: &mut impl Observer,
        visit: &mut dyn FnMut(Point) -> bool,
    ) {
        dispatch!(self, it => it.visit_crossings(segment, is_origin, observer, visit));
    }

    /// See [`Primitive::is_disjoint`].
    pub(crate) fn is_disjoint(&self, sphere: &BoundingSphere) -> bool {
        dispatch!(self, it => it.is_disjoint(sphere))
    }

    /// See [`Primitive::may_separate`].
    pub(crate) fn may_separate(&self, point: Vec3<Length>, sphere: &BoundingSphere) -> bool {
        dispatch!(self, it => it.may_separate(point, sphere))
    }

    /// Tag of the shape in a compiled scene.
    fn tag(&self) -> u8 {
        dispatch!(self, it => it.tag())
    }

    /// Returns a placeholder shape of the kind that a tag in a compiled scene stands for. Decoding
    /// later fills the fields of the shape. For an unknown tag, returns a sphere with radius 0,
    /// which is not valid.
    fn of_tag(tag: u8) -> Self {
        #[cfg(feature = "quadrics")]
        if let Some(quadric) = Quadric::of_tag(tag) {
            return Self::Quadric(quadric);
        }
        match tag {
            plane::TAG | plane::CLIPPED_TAG => Self::Plane(Plane::of_tag(tag)),
            #[cfg(feature = "sphereflake")]
            sphereflake::TAG => Self::Sphereflake(Sphereflake::default()),
            _ => Self::Sphere(Sphere::default()),
        }
    }
}

/// Returns the name of the Cargo feature that a shape tag needs, if that feature is off.
fn missing_feature(tag: u8) -> Option<&'static str> {
    match tag {
        3..=6 if cfg!(not(feature = "quadrics")) => Some("quadrics"),
        7 if cfg!(not(feature = "sphereflake")) => Some("sphereflake"),
        _ => None,
    }
}

impl Fields for Shape {
    fn visit(&mut self, archive: &mut impl Archive) {
        let tag = self.tag();
        let mut read = tag;
        read.visit(archive);
        if read != tag {
            *self = Self::of_tag(read);
            if let Some(feature) = missing_feature(read) {
                archive.miss(feature);
            }
        }
        dispatch!(self, it => it.visit(archive));
    }
}
