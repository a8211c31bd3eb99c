use super::quadratic::Quadratic;
use crate::archive::Fields;
use crate::math::{Length, Unit, Vec3};
use crate::observer::ShapeKind;

/// The operations that differ between quadrics.
///
/// Coordinates count from the center of the quadric, in steps of `2^shift`.
pub(in super::super) trait QuadricForm: Fields {
    /// Kind of the shape, for observers.
    const KIND: ShapeKind;
    /// Tag in a compiled scene.
    const TAG: u8;

    /// Largest radius within a distance from the center along y, if that is near.
    fn max_radius(&self, height: Length) -> Option<Length>;

    /// The equation of a ray with its origin at `offset` from the center.
    fn quadratic(&self, offset: Vec3<Length>, direction: Vec3<Unit>, shift: u8) -> Quadratic;

    /// A vector along the normal that points outward, or away from the axis.
    fn gradient(&self, offset: Vec3<Length>, shift: u8) -> Vec3<i64>;

    /// Returns true if every field is in the range that tracing relies on.
    fn is_valid(&self) -> bool;
}
