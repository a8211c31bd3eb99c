use whitted::animation::Target;
use whitted::{Object, Shape};

use super::value::Value;

/// What the values of a track's keys are.
#[derive(Clone, Copy)]
pub(super) enum Form {
    Point,
    Color,
    Number,
    /// Yaw, or yaw and pitch.
    Angles,
}

/// What a track may move, by the key that says where it is while it is still.
pub(super) struct Named {
    /// `objects.ball.center`
    pub(super) name: String,
    pub(super) target: Target,
    pub(super) form: Form,
}

/// All that can move in a scene.
pub(super) fn targets(
    objects: &[Object],
    object_names: &[Option<Value<'_>>],
    light_names: &[Option<Value<'_>>],
) -> Vec<Named> {
    let mut targets = Vec::new();
    let mut add = |name: String, target, form| targets.push(Named { name, target, form });
    add("camera.orbit".into(), Target::CameraOrbit, Form::Angles);
    add("camera.eye".into(), Target::CameraEye, Form::Point);
    add("camera.look_at".into(), Target::CameraLookAt, Form::Point);
    add("camera.fovy_deg".into(), Target::CameraFovy, Form::Number);
    for (index, name, object) in named(object_names)
        .filter_map(|(index, name)| Some((index, name, objects.get(usize::from(index))?)))
    {
        let position = position_key(&object.shape);
        add(
            format!("objects.{name}.{position}"),
            Target::ObjectPosition(index),
            Form::Point,
        );
        if has_radius(&object.shape) {
            add(
                format!("objects.{name}.radius"),
                Target::ObjectRadius(index),
                Form::Number,
            );
        }
    }
    for (index, name) in named(light_names) {
        let light = |key: &str| format!("lights.{name}.{key}");
        add(light("position"), Target::LightPosition(index), Form::Point);
        add(light("color"), Target::LightColor(index), Form::Color);
    }
    targets
}

fn named<'a>(names: &'a [Option<Value<'a>>]) -> impl Iterator<Item = (u16, &'a str)> {
    let text = |name: &'a Option<Value<'a>>| name.as_ref()?.text("a string").ok();
    (0..)
        .zip(names)
        .filter_map(move |(index, name)| Some((index, text(name)?)))
}

fn position_key(shape: &Shape) -> &'static str {
    match shape {
        Shape::Sphere { .. } | Shape::Ellipsoid { .. } | Shape::Sphereflake { .. } => "center",
        Shape::Plane { .. } => "point",
        _ => "origin",
    }
}

fn has_radius(shape: &Shape) -> bool {
    matches!(
        shape,
        Shape::Sphere { .. }
            | Shape::Cylinder { .. }
            | Shape::Cone { .. }
            | Shape::Sphereflake { .. }
    )
}
