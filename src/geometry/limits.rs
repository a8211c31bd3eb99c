//! Ranges of numbers, and what to say of those that are not within.

use fixed::types::U0F32;

use crate::geometry::Normalization;
use crate::math::{Real, Vec3};
use crate::scene::{SceneError, SceneItem, SceneProblem};

/// The farthest coordinate, ±2^24: sums and differences keep within [`Real`].
pub(crate) const FARTHEST: Real = Real::lit("16777216");
/// The least size of anything, world units.
pub(crate) const SMALLEST: Real = Real::lit("0.000001");

pub(crate) fn fail<T>(
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

pub(crate) fn range(
    item: SceneItem,
    field: &'static str,
    value: Real,
    [least, most]: [Real; 2],
) -> Result<(), SceneError> {
    if (least..=most).contains(&value) {
        Ok(())
    } else {
        fail(item, field, SceneProblem::OutOfRange { least, most })
    }
}

pub(crate) fn point(
    item: SceneItem,
    field: &'static str,
    point: Vec3<Real>,
) -> Result<(), SceneError> {
    [point.x, point.y, point.z]
        .into_iter()
        .try_for_each(|c| range(item, field, c, [-FARTHEST, FARTHEST]))
}

pub(crate) fn interval(
    item: SceneItem,
    field: &'static str,
    ends: [Real; 2],
) -> Result<(), SceneError> {
    let [low, high] = ends;
    range(item, field, low, [-FARTHEST, FARTHEST])?;
    range(item, field, high, [-FARTHEST, FARTHEST])?;
    if low < high {
        Ok(())
    } else {
        fail(item, field, SceneProblem::EmptyInterval)
    }
}

/// A paraboloid must be as high and, where it ends, as wide as any size.
pub(crate) fn least_rise(
    item: SceneItem,
    y: [Real; 2],
    frame: &Normalization,
) -> Result<(), SceneError> {
    let least = frame.smallest().max(SMALLEST);
    let least = least.max(least.saturating_mul(least));
    range(item, "y[1]", y[1], [least, FARTHEST])
}

/// The smallest spheres of a flake must be as large as any size.
pub(crate) fn least_sphere(
    item: SceneItem,
    radius: Real,
    ratio: U0F32,
    depth: u8,
    frame: &Normalization,
) -> Result<(), SceneError> {
    let least = frame.smallest().max(SMALLEST);
    let smaller =
        |radius: &i64| Some(((i128::from(*radius) * i128::from(ratio.to_bits())) >> 32) as i64);
    let generations = core::iter::successors(Some(radius.to_bits()), smaller)
        .take(usize::from(depth) + 1)
        .take_while(|radius| *radius >= least.to_bits())
        .count();
    let most = (generations as u8).saturating_sub(1);
    range(item, "depth", depth.into(), [Real::ZERO, most.into()])
}

/// A size must be at least 2^10 steps of the scene's scale to be round; below 0
/// as well as above.
pub(crate) fn least_size(
    item: SceneItem,
    field: &'static str,
    size: Real,
    frame: &Normalization,
) -> Result<(), SceneError> {
    let least = frame.smallest().max(SMALLEST);
    let sizes = if size < 0 {
        [-FARTHEST, -least]
    } else {
        [least, FARTHEST]
    };
    range(item, field, size, sizes)
}
