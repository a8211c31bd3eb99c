//! Ranges of authored numbers, and the errors of numbers outside of them.

use super::normalization::Normalization;
use crate::math::{Real, Vec3};
use crate::scene::{SceneError, SceneItem, SceneProblem};

/// Largest coordinate: sums and differences of coordinates stay within [`Real`].
pub(crate) const FARTHEST: Real = Real::lit("16777216");
/// Smallest size, in world units.
pub(crate) const SMALLEST: Real = Real::lit("0.000001");

/// Returns an error about a field of an item.
pub(crate) fn error<T>(
    item: SceneItem,
    field: &'static str,
    problem: SceneProblem,
) -> Result<T, SceneError> {
    Err(SceneError {
        item,
        field,
        problem,
    })
}

/// Checks that a number is within a range that includes both ends.
pub(crate) fn range(
    item: SceneItem,
    field: &'static str,
    value: Real,
    [least, most]: [Real; 2],
) -> Result<(), SceneError> {
    if (least..=most).contains(&value) {
        Ok(())
    } else {
        error(item, field, SceneProblem::OutOfRange { least, most })
    }
}

/// Checks the coordinates of a point or a vector.
pub(crate) fn point(
    item: SceneItem,
    field: &'static str,
    point: Vec3<Real>,
) -> Result<(), SceneError> {
    [point.x, point.y, point.z]
        .into_iter()
        .try_for_each(|c| range(item, field, c, [-FARTHEST, FARTHEST]))
}

/// Checks a size such as a radius.
pub(crate) fn size(item: SceneItem, field: &'static str, size: Real) -> Result<(), SceneError> {
    range(item, field, size, [SMALLEST, FARTHEST])
}

/// Checks that an interval runs from a lower to a higher coordinate.
pub(crate) fn interval(
    item: SceneItem,
    field: &'static str,
    [low, high]: [Real; 2],
) -> Result<(), SceneError> {
    range(item, field, low, [-FARTHEST, FARTHEST])?;
    range(item, field, high, [-FARTHEST, FARTHEST])?;
    if low < high {
        Ok(())
    } else {
        error(item, field, SceneProblem::EmptyInterval)
    }
}

/// Checks that a size, positive or negative, is at least 2^10 steps of the prepared scene, so
/// that curved surfaces look round.
pub(crate) fn resolvable_size(
    item: SceneItem,
    field: &'static str,
    size: Real,
    normalization: &Normalization,
) -> Result<(), SceneError> {
    let least = least_size(normalization);
    let sizes = if size < 0 {
        [-FARTHEST, -least]
    } else {
        [least, FARTHEST]
    };
    range(item, field, size, sizes)
}

/// Smallest size that the scale of a scene resolves, in world units.
pub(crate) fn least_size(normalization: &Normalization) -> Real {
    normalization.smallest_size().max(SMALLEST)
}
