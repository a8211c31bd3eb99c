//! The operations of a shape. Each file of a shape implements both traits.

use super::bounding_sphere::BoundingSphere;
use super::extent::Extent;
use super::normalization::Normalization;
use super::point::Point;
use super::ray::Ray;
use super::shadow_segment::ShadowSegment;
use super::surface::SurfaceFlags;
use crate::archive::Fields;
use crate::math::{Length, SoftFloat, Unit, Vec3};
use crate::observer::Observer;
use crate::scene::{SceneError, SceneItem};

/// The authored form of a shape: what is validated and prepared.
pub(crate) trait AuthoredShape {
    /// The prepared form.
    type Prepared;

    /// Checks all that does not depend on the scale of the scene.
    fn validate(&self, item: SceneItem) -> Result<(), SceneError>;

    /// Adds the bounded parts of the shape to the extent of the scene.
    fn extend(&self, extent: &mut Extent);

    /// Largest exponent of the scale at which the shape can be prepared. `is_alone` if the
    /// scene has no bounded geometry.
    fn max_exponent(&self, center: Vec3<i64>, is_alone: bool) -> i32 {
        let _ = (center, is_alone);
        i32::MAX
    }

    /// Converts the shape to the formats of the prepared scene.
    fn prepare(
        &self,
        normalization: &Normalization,
        item: SceneItem,
    ) -> Result<Self::Prepared, SceneError>;
}

/// The part of a composite shape that a ray hit: a sphere of a sphereflake.
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
    /// Part of a composite shape; 0 for other shapes.
    pub(crate) part: u32,
}

impl SurfacePoint {
    /// A point of a shape without parts.
    #[inline(always)]
    pub(super) fn new(normal: Vec3<Unit>) -> Self {
        Self { normal, part: 0 }
    }
}

/// The prepared form of a shape: what rays are tested against.
///
/// Distances come first, for every object that a ray may hit. The normal is computed for the
/// nearest hit only.
pub(crate) trait Primitive: Fields {
    /// Returns true if every field is in the range that tracing relies on, after decoding.
    fn is_valid(&self) -> bool;

    /// Flags of the surface.
    fn flags(&self) -> SurfaceFlags;

    /// A sphere around the shape; `None` if the shape is unbounded.
    fn bounding_sphere(&self) -> Option<BoundingSphere>;

    /// Returns true if the shape is its bounding sphere.
    fn is_sphere(&self) -> bool {
        false
    }

    /// Returns true if every hit point of a near ray is near, which saves a test.
    fn is_near(&self) -> bool {
        false
    }

    /// Distance of the nearest hit of a ray from a near origin. Exact if below `limit`, and
    /// [`Length::MAX`] if the hit may be beyond the near range.
    ///
    /// `is_origin` if the ray leaves the surface of this shape. A hit part of a composite
    /// shape is written to `part` if the hit is below `limit`. Reports every test of a
    /// surface to the observer.
    fn intersect(
        &self,
        ray: &Ray,
        is_origin: bool,
        limit: Length,
        part: &mut PrimitivePart,
        observer: &mut impl Observer,
    ) -> Option<Length>;

    /// Distance of the nearest hit at any distance from any origin, for unbounded shapes;
    /// `None` for bounded ones.
    fn intersect_extended(&self, ray: &Ray, is_origin: bool) -> Option<SoftFloat> {
        let _ = (ray, is_origin);
        None
    }

    /// Returns true if a point of the unclipped surface belongs to the shape.
    fn covers(&self, point: &Point) -> bool {
        let _ = point;
        true
    }

    /// Surface properties at a hit point.
    fn surface_at(&self, point: &Point, part: &PrimitivePart) -> SurfacePoint;

    /// Number of crossings of a shadow segment, if it is known without a square root.
    ///
    /// `any` if one crossing is enough to occlude the light: a shape then may count no
    /// further than one.
    fn count_crossings(
        &self,
        segment: &ShadowSegment<'_>,
        is_origin: bool,
        any: bool,
        observer: &mut impl Observer,
    ) -> Option<u8>;

    /// Visits the points where a shadow segment crosses the shape, in no order, until `visit`
    /// returns false.
    fn visit_crossings(
        &self,
        segment: &ShadowSegment<'_>,
        is_origin: bool,
        observer: &mut impl Observer,
        visit: &mut dyn FnMut(Point) -> bool,
    );

    /// Returns true if the shape does not reach into a sphere.
    fn is_disjoint(&self, sphere: &BoundingSphere) -> bool {
        self.bounding_sphere()
            .is_some_and(|bound| bound.is_disjoint(sphere))
    }

    /// Returns true if an unbounded shape may be between a point and a part of a sphere.
    fn may_separate(&self, point: Vec3<Length>, sphere: &BoundingSphere) -> bool {
        let _ = (point, sphere);
        true
    }
}
