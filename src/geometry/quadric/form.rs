use super::quadratic::Quadratic;
use crate::archive::Fields;
use crate::math::{Length, Unit, Vec3};
use crate::observer::ShapeKind;

/// The operations that differ between ellipsoids, cylinders, cones and paraboloids.
///
/// Points are given by their offset from the center of the quadric, in units of
/// `2^(shift - 28)`.
pub(in super::super) trait QuadricForm: Fields {
    /// Kind of the shape, for observers.
    const KIND: ShapeKind;
    /// Tag in a compiled scene.
    const TAG: u8;

    /// Returns the largest radius that the quadric has at any height within `height` of its center.
    /// Returns `None` if that radius is about 8 or more.
    fn max_radius(&self, height: Length) -> Option<Length>;

    /// Returns the quadratic equation for the hits of a ray that starts at `offset` from the
    /// center.
    fn quadratic(&self, offset: Vec3<Length>, direction: Vec3<Unit>, shift: u8) -> Quadratic;

    /// Returns a vector along the normal. The vector points to the outside of an ellipsoid, and
    /// away from the axis of any other quadric.
    fn gradient(&self, offset: Vec3<Length>, shift: u8) -> Vec3<i64>;

    /// Returns true if every field is in the range for which tracing is correct.
    fn is_valid(&self) -> bool;
}
