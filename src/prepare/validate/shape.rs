//! What a shape may be.

use crate::geometry::MAX_FLAKE_DEPTH;
use crate::geometry::limits::{FARTHEST, SMALLEST, interval, point, range};
use crate::math::Real;
use crate::scene::{SceneError, SceneItem, Shape};

/// The longest radius of an ellipsoid in its shortest one: 2^8.
const FLATTEST: u32 = 8;
/// The height of a cone in its radius, or the other way round: 2^10.
const STEEPEST: u32 = 10;

pub(super) fn shape(item: SceneItem, shape: &Shape) -> Result<(), SceneError> {
    let size = |field, size| range(item, field, size, [SMALLEST, FARTHEST]);
    match *shape {
        Shape::Sphere { center, radius } => {
            point(item, "center", center)?;
            size("radius", radius)
        }
        Shape::Ellipsoid { center, radii } => {
            point(item, "center", center)?;
            let [shortest, longest] = [
                radii.x.min(radii.y).min(radii.z),
                radii.x.max(radii.y).max(radii.z),
            ];
            size("radii", shortest)?;
            size("radii", longest)?;
            range(item, "radii", shortest, [longest >> FLATTEST, longest])
        }
        Shape::Cylinder { origin, radius, y } => {
            point(item, "origin", origin)?;
            size("radius", radius)?;
            y.map_or(Ok(()), |y| interval(item, "y", y))
        }
        Shape::Cone {
            origin,
            radius,
            height,
            y,
        } => {
            point(item, "origin", origin)?;
            size("radius", radius)?;
            let least = (radius >> STEEPEST).max(SMALLEST);
            let most = radius.saturating_mul(Real::ONE << STEEPEST).min(FARTHEST);
            let heights = if height < 0 {
                [-most, -least]
            } else {
                [least, most]
            };
            range(item, "height", height, heights)?;
            let Some(y) = y else { return Ok(()) };
            interval(item, "y", y)?;
            // Where it is as wide as the world.
            let steepness = height.abs().checked_div(radius).unwrap_or(Real::ZERO);
            let reach = FARTHEST.saturating_mul(steepness).min(FARTHEST);
            let within = [height - reach, height + reach];
            y.into_iter().try_for_each(|y| range(item, "y", y, within))
        }
        Shape::Paraboloid { origin, y } => {
            point(item, "origin", origin)?;
            interval(item, "y", y)?;
            size("y[1]", y[1])
        }
        Shape::Plane {
            normal,
            point: p,
            bounds,
        } => {
            point(item, "normal", normal)?;
            point(item, "point", p)?;
            [
                ("bounds.x", bounds.x),
                ("bounds.y", bounds.y),
                ("bounds.z", bounds.z),
            ]
            .into_iter()
            .try_for_each(|(field, bound)| bound.map_or(Ok(()), |b| interval(item, field, b)))
        }
        Shape::Sphereflake {
            center,
            radius,
            depth,
            ratio,
            frame,
        } => {
            point(item, "center", center)?;
            size("radius", radius)?;
            range(
                item,
                "depth",
                depth.into(),
                [Real::ZERO, MAX_FLAKE_DEPTH.into()],
            )?;
            range(
                item,
                "ratio",
                ratio,
                const { [Real::lit("0.1"), Real::lit("0.5")] },
            )?;
            frame
                .into_iter()
                .try_for_each(|row| point(item, "frame", row))
        }
    }
}
