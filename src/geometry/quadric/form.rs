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

    /// Returns the largest radius of the quadric at heights up to `height` above or below its
    /// center. Returns `None` if that radius is too large for a near distance.
    fn max_radius(&self, height: Length) -> Option<Length>;

    /// Returns the quadratic equation of a ray that starts at `offset` from the center.
    fn quadratic(&self, offset: Vec3<Length>, direction: Vec3<Unit>, shift: u8) -> Quadratic;

    /// Returns a vector along the normal. It points outward, or away from the axis.
    fn gradient(&self, offset: Vec3<Length>, shift: u8) -> Vec3<i64>;

    /// Returns true if every field is in the range that tracing relies on.
    fn is_valid(&self) -> bool;
}
