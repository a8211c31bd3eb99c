use whitted::Real;
use whitted::animation::Target;

use super::light::NamedLight;
use super::object::NamedObject;
use super::value::Value;

/// Type of the values of an animation track.
#[derive(Clone, Copy)]
pub(super) enum ValueKind {
    Point,
    Color,
    Number,
    /// Angles of the camera: yaw, or yaw and pitch.
    Angles,
}

/// Largest magnitude of a coordinate.
const FARTHEST: Real = Real::lit("16777216");

/// Returns the smallest and the largest number that the values of a target may have, if there are
/// limits. The prepared scene may have narrower limits.
pub(super) fn limits(target: Target) -> Option<[Real; 2]> {
    match target {
        Target::CameraEye
        | Target::CameraLookAt
        | Target::ObjectPosition(_)
        | Target::LightPosition(_) => Some([-FARTHEST, FARTHEST]),
        Target::CameraFovy => Some(const { [Real::lit("1"), Real::lit("170")] }),
        Target::ObjectRadius(_) => Some(const { [Real::lit("0.000001"), FARTHEST] }),
        Target::LightColor(_) => Some(const { [Real::ZERO, Real::lit("256")] }),
        _ => None,
    }
}

/// An animation target and the path that names it in the file.
pub(super) struct NamedTarget {
    /// Path of the animated key, such as `objects.ball.center`.
    pub(super) path: String,
    pub(super) target: Target,
    pub(super) kind: ValueKind,
}

impl NamedTarget {
    fn new(path: impl Into<String>, target: Target, kind: ValueKind) -> Self {
        Self {
            path: path.into(),
            target,
            kind,
        }
    }
}

/// Returns all animation targets of a scene: the camera, and the named objects and lights.
pub(super) fn targets(objects: &[NamedObject<'_>], lights: &[NamedLight<'_>]) -> Vec<NamedTarget> {
    let mut targets = vec![
        NamedTarget::new("camera.orbit", Target::CameraOrbit, ValueKind::Angles),
        NamedTarget::new("camera.eye", Target::CameraEye, ValueKind::Point),
        NamedTarget::new("camera.look_at", Target::CameraLookAt, ValueKind::Point),
        NamedTarget::new("camera.fovy_deg", Target::CameraFovy, ValueKind::Number),
    ];
    for (index, object) in (0..).zip(objects) {
        if let Some(name) = text(&object.name) {
            targets.extend(object_targets(index, name, object));
        }
    }
    for (index, light) in (0..).zip(lights) {
        if let Some(name) = text(&light.name) {
            targets.extend(light_targets(index, name));
        }
    }
    targets
}

fn object_targets(
    index: u16,
    name: &str,
    object: &NamedObject<'_>,
) -> impl Iterator<Item = NamedTarget> {
    let position = NamedTarget::new(
        format!("objects.{name}.{}", object.shape.position_key),
        Target::ObjectPosition(index),
        ValueKind::Point,
    );
    let radius = object.shape.has_radius().then(|| {
        NamedTarget::new(
            format!("objects.{name}.radius"),
            Target::ObjectRadius(index),
            ValueKind::Number,
        )
    });
    std::iter::once(position).chain(radius)
}

fn light_targets(index: u16, name: &str) -> [NamedTarget; 2] {
    [
        NamedTarget::new(
            format!("lights.{name}.position"),
            Target::LightPosition(index),
            ValueKind::Point,
        ),
        NamedTarget::new(
            format!("lights.{name}.color"),
            Target::LightColor(index),
            ValueKind::Color,
        ),
    ]
}

fn text<'a>(name: &Option<Value<'a>>) -> Option<&'a str> {
    name.as_ref()?.text("a string").ok()
}
