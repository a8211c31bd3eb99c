//! Limits of authored numbers, and checks that return an error for a number beyond its limits.

use super::normalization::Normalization;
use crate::math::{Real, Vec3};
use crate::scene::{SceneError, SceneItem, SceneProblem};

/// Largest magnitude of an authored coordinate. The limit ensures that sums and differences of
/// coordinates fit a [`Real`].
pub(crate) const FARTHEST: Real = Real::lit("16777216");
/// Smallest authored size, in world units.
pub(crate) const SMALLEST: Real = Real::lit("0.000001");

/// Returns an error that reports a problem with a field of a scene item.
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

/// Checks that a number is at least `least` and at most `most`.
#[inline(never)]
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
#[inline(never)]
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
#[inline(never)]
pub(crate) fn size(item: SceneItem, field: &'static str, size: Real) -> Result<(), SceneError> {
    range(item, field, size, [SMALLEST, FARTHEST])
}

/// Checks that the lower end of an interval is below the upper end.
#[inline(never)]
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

/// Checks that the magnitude of a size is at least 2^-18 in the prepared scene, which is 2^10
/// units of a `Length`. Curved surfaces of a smaller size would not look round.
#[inline(never)]
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

/// Returns the smallest size, in world units, that the preparation of a scene accepts. The
/// limit depends on the scale of the scene.
pub(crate) fn least_size(normalization: &Normalization) -> Real {
    normalization.smallest_size().max(SMALLEST)
}
