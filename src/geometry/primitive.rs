//! Defines two traits that every shape implements. [`AuthoredShape`] covers validation and
//! preparation. [`Primitive`] covers ray tests.

use super::bounding_sphere::BoundingSphere;
use super::extent::Extent;
use super::normalization::Normalization;
use super::point::Point;
use super::ray::Ray;
use super::shadow_segment::ShadowSegment;
use super::surface::SurfaceFlags;
use crate::archive::Fields;
use crate::math::{Length, SoftFloat, Unit, Vec3};
use crate::observer::{Observer, ShapeKind};
use crate::scene::{SceneError, SceneItem};

/// A shape as authored, in world units. It is validated and then prepared.
pub(crate) trait AuthoredShape {
    /// Type of the prepared shape.
    type Prepared;

    /// Checks every property of the shape that does not depend on the scale of the scene.
    fn validate(&self, item: SceneItem) -> Result<(), SceneError>;

    /// Adds the bounded parts of the shape to the extent of the scene.
    fn extend(&self, extent: &mut Extent);

    /// Returns the largest exponent of the scale at which the shape can be prepared. The scale
    /// of a scene is a power of two. `is_alone` is true if the scene has no bounded geometry.
    fn max_exponent(&self, center: Vec3<i64>, is_alone: bool) -> i32 {
        let _ = (center, is_alone);
        i32::MAX
    }

    /// Converts the shape to prepared units and to the number formats of the prepared scene.
    fn prepare(
        &self,
        normalization: &Normalization,
        item: SceneItem,
    ) -> Result<Self::Prepared, SceneError>;
}

/// The part of a composite shape that a ray hit, such as one sphere of a sphereflake.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct PrimitivePart {
    /// Identifies the part within its shape.
    pub(crate) id: u32,
    /// Outward unit normal at the hit point.
    pub(crate) normal: Vec3<Unit>,
}

/// Properties of a surface at a hit point.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SurfacePoint {
    /// Outward unit normal.
    pub(crate) normal: Vec3<Unit>,
    /// Id of the hit part of a composite shape; 0 for other shapes.
    pub(crate) part: u32,
}

impl SurfacePoint {
    /// Returns a surface point of a shape that has no parts.
    #[inline(always)]
    pub(super) fn new(normal: Vec3<Unit>) -> Self {
        Self { normal, part: 0 }
    }
}

/// A prepared shape, which rays are tested against.
///
/// The distance of the hit is computed for every object that a ray may hit. The normal is
/// computed only for the nearest hit.
pub(crate) trait Primitive: Fields {
    /// Returns true if every field is in the range that ray tracing needs. This check runs
    /// after a compiled scene is decoded.
    fn is_valid(&self) -> bool;

    /// Returns the kind of the shape, for observers.
    fn kind(&self) -> ShapeKind;

    /// Returns the flags of the surface.
    fn flags(&self) -> SurfaceFlags;

    /// Returns a sphere that encloses the shape, or `None` if the shape is unbounded.
    fn bounding_sphere(&self) -> Option<BoundingSphere>;

    /// Returns true if the shape is a sphere and thus equal to its bounding sphere.
    fn is_sphere(&self) -> bool {
        false
    }

    /// Returns true if the whole shape is in the near range (each coordinate within ±3.5). Hit
    /// points of such a shape need no range test.
    fn is_near(&self) -> bool {
        false
    }

    /// Returns the distance of the nearest hit. The origin of the ray must be in the near range
    /// (each coordinate within ±3.5). The distance is exact if it is below `limit`. If the hit
    /// may be beyond the near range, the result is [`Length::MAX`].
    ///
    /// `is_origin` is true if the ray starts on the surface of this shape. If the distance is
    /// below `limit`, a composite shape stores the part that was hit in `part`. Every test of a
    /// surface is reported to the observer.
    fn intersect(
        &self,
        ray: &Ray,
        is_origin: bool,
        limit: Length,
        part: &mut PrimitivePart,
        observer: &mut impl Observer,
    ) -> Option<Length>;

    /// Returns the distance of the nearest hit. The origin and the hit may be in the near or
    /// the extended range. Bounded shapes always return `None`.
    fn intersect_extended(&self, ray: &Ray, is_origin: bool) -> Option<SoftFloat> {
        let _ = (ray, is_origin);
        None
    }

    /// Returns true if a point of the surface remains after clipping.
    fn covers(&self, point: &Point) -> bool {
        let _ = point;
        true
    }

    /// Returns the surface properties at a hit point.
    fn surface_at(&self, point: &Point, part: &PrimitivePart) -> SurfacePoint;

    /// Returns the number of times that a shadow segment crosses the shape. Returns `None` if
    /// counting needs the crossing points, because computing them takes a square root or a
    /// division.
    ///
    /// `any` is true if one crossing is enough to occlude the light. A shape may then stop
    /// counting after the first crossing.
    fn count_crossings(
        &self,
        segment: &ShadowSegment<'_>,
        is_origin: bool,
        any: bool,
        observer: &mut impl Observer,
    ) -> Option<u8>;

    /// Calls `visit` with each point where a shadow segment crosses the shape. The order of the
    /// points is arbitrary. The calls stop when `visit` returns false.
    fn visit_crossings(
        &self,
        segment: &ShadowSegment<'_>,
        is_origin: bool,
        observer: &mut impl Observer,
        visit: &mut dyn FnMut(Point) -> bool,
    );

    /// Returns true if no part of the shape is inside a sphere.
    fn is_disjoint(&self, sphere: &BoundingSphere) -> bool {
        self.bounding_sphere()
            .is_some_and(|bound| bound.is_disjoint(sphere))
    }

    /// Returns true if this shape, which is unbounded, may lie between a point and some part of
    /// a sphere.
    fn may_separate(&self, point: Vec3<Length>, sphere: &BoundingSphere) -> bool {
        let _ = (point, sphere);
        true
    }
}
