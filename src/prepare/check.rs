//! What may be in a scene.

use fixed::types::U0F32;

use crate::num::{Factor, Real, factor};
use crate::prepared::MAX_DEPTH;
use crate::scene::{Background, Camera, Light, Material, Object, Shape, Texture};
use crate::shape::MAX_FLAKE_DEPTH;
use crate::{Color, Item, MaterialId, Problem, Scene, SceneError, Vec3};

use super::frame::Frame;

/// The farthest coordinate, ±2^24: sums and differences keep within [`Real`].
const FARTHEST: Real = Real::lit("16777216");
/// The brightest light, emission, ambient light or background.
const BRIGHTEST: Real = Real::lit("256");
/// The longest radius of an ellipsoid in its shortest one: 2^8.
const FLATTEST: u32 = 8;
/// The height of a cone in its radius, or the other way round: 2^10.
const STEEPEST: u32 = 10;
/// The least size of anything, world units.
const SMALLEST: Real = Real::lit("0.000001");

pub(super) fn fail<T>(item: Item, field: &'static str, problem: Problem) -> Result<T, SceneError> {
    Err(SceneError {
        item,
        field,
        problem,
    })
}

fn range(
    item: Item,
    field: &'static str,
    value: Real,
    [least, most]: [Real; 2],
) -> Result<(), SceneError> {
    if (least..=most).contains(&value) {
        Ok(())
    } else {
        fail(item, field, Problem::OutOfRange { least, most })
    }
}

fn point(item: Item, field: &'static str, point: Vec3<Real>) -> Result<(), SceneError> {
    [point.x, point.y, point.z]
        .into_iter()
        .try_for_each(|c| range(item, field, c, [-FARTHEST, FARTHEST]))
}

fn color(
    item: Item,
    field: &'static str,
    color: Color<Real>,
    most: Real,
) -> Result<(), SceneError> {
    [color.r, color.g, color.b]
        .into_iter()
        .try_for_each(|c| range(item, field, c, [Real::ZERO, most]))
}

/// Checks all that does not depend on the scene's scale.
pub(super) fn scene(scene: &Scene<'_>) -> Result<(), SceneError> {
    max_depth(scene.max_depth)?;
    min_weight(scene.min_weight)?;
    color(Item::Scene, "ambient", scene.ambient, BRIGHTEST)?;
    match scene.background {
        Background::Solid(solid) => color(Item::Scene, "background", solid, BRIGHTEST)?,
        Background::Gradient { horizon, zenith } => {
            color(Item::Scene, "background.horizon", horizon, BRIGHTEST)?;
            color(Item::Scene, "background.zenith", zenith, BRIGHTEST)?;
        }
    }
    camera(&scene.camera)?;
    (0..)
        .zip(scene.lights)
        .try_for_each(|(index, l)| light(Item::Light(index), l))?;
    (0..)
        .zip(scene.materials)
        .try_for_each(|(index, m)| material(Item::Material(index), m))?;
    (0..)
        .zip(scene.objects)
        .try_for_each(|(index, o)| object(Item::Object(index), o, scene.materials.len()))
}

pub(crate) fn max_depth(max_depth: u8) -> Result<u8, SceneError> {
    range(
        Item::Scene,
        "max_depth",
        max_depth.into(),
        [Real::ZERO, MAX_DEPTH.into()],
    )?;
    Ok(max_depth)
}

pub(crate) fn min_weight(min_weight: Real) -> Result<Factor, SceneError> {
    range(
        Item::Scene,
        "min_weight",
        min_weight,
        [Real::ZERO, Real::ONE],
    )?;
    Ok(factor(min_weight, 0))
}

fn camera(camera: &Camera) -> Result<(), SceneError> {
    let item = Item::Camera;
    point(item, "eye", camera.eye)?;
    point(item, "look_at", camera.look_at)?;
    point(item, "up", camera.up)?;
    range(
        item,
        "fovy_deg",
        camera.fovy_deg,
        const { [Real::lit("1"), Real::lit("170")] },
    )
}

fn light(item: Item, light: &Light) -> Result<(), SceneError> {
    point(item, "position", light.position)?;
    color(item, "diffuse", light.diffuse, BRIGHTEST)?;
    color(item, "specular", light.specular, BRIGHTEST)
}

fn material(item: Item, material: &Material) -> Result<(), SceneError> {
    for (field, coefficient) in [
        ("ka", material.ka),
        ("kd", material.kd),
        ("ks", material.ks),
        ("kr", material.kr),
        ("kt", material.kt),
    ] {
        color(item, field, coefficient, Real::ONE)?;
    }
    color(item, "le", material.le, BRIGHTEST)?;
    let black = Color::gray(Real::ZERO);
    if material.ks != black {
        range(
            item,
            "shininess",
            material.shininess,
            const { [Real::ONE, Real::lit("4096")] },
        )?;
    }
    if material.kt != black {
        range(
            item,
            "ior",
            material.ior,
            const { [Real::ONE, Real::lit("4")] },
        )?;
    }
    Ok(())
}

fn object(item: Item, object: &Object, materials: usize) -> Result<(), SceneError> {
    shape(item, &object.shape)?;
    let known = |field, MaterialId(index)| {
        if usize::from(index) < materials {
            Ok(())
        } else {
            fail(item, field, Problem::NoSuchMaterial(index))
        }
    };
    match object.texture {
        Texture::Uniform(material) => known("material", material),
        Texture::Checker {
            size,
            axes: [first, second],
            materials,
        } => {
            range(item, "checker.size", size, [SMALLEST, FARTHEST])?;
            if first == second {
                return fail(item, "checker.axes", Problem::SameAxis);
            }
            materials
                .into_iter()
                .try_for_each(|material| known("checker.materials", material))
        }
    }
}

fn shape(item: Item, shape: &Shape) -> Result<(), SceneError> {
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

fn interval(item: Item, field: &'static str, ends: [Real; 2]) -> Result<(), SceneError> {
    let [low, high] = ends;
    range(item, field, low, [-FARTHEST, FARTHEST])?;
    range(item, field, high, [-FARTHEST, FARTHEST])?;
    if low < high {
        Ok(())
    } else {
        fail(item, field, Problem::EmptyInterval)
    }
}

/// A paraboloid must be as wide, where it ends, as any size.
pub(super) fn least_rise(item: Item, y: [Real; 2], frame: &Frame) -> Result<(), SceneError> {
    let least = frame.smallest().max(SMALLEST);
    let least = [least, least.saturating_mul(least), SMALLEST]
        .into_iter()
        .fold(Real::ZERO, Real::max);
    range(item, "y[1]", y[1], [least, FARTHEST])
}

/// The smallest spheres of a flake must be as large as any size.
pub(super) fn least_sphere(
    item: Item,
    radius: Real,
    ratio: U0F32,
    depth: u8,
    frame: &Frame,
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
pub(super) fn least_size(
    item: Item,
    field: &'static str,
    size: Real,
    frame: &Frame,
) -> Result<(), SceneError> {
    let least = frame.smallest().max(SMALLEST);
    let sizes = if size < 0 {
        [-FARTHEST, -least]
    } else {
        [least, FARTHEST]
    };
    range(item, field, size, sizes)
}
