use toml::de::DeValue;
use whitted::animation::Keyframe;
use whitted::scene::SceneProblem;
use whitted::{Real, Vec3};

use super::error::LoadError;
use super::example::example;
use super::table::Table;
use super::target::{NamedTarget, ValueKind, limits};
use super::value::Value;
use crate::text::excerpt;

/// Largest number of keyframes of a track.
const MAX_KEYS: usize = u16::MAX as usize;

/// Reads the keyframes of a track.
pub(super) fn keyframes(
    table: &Table<'_>,
    named: &NamedTarget,
) -> Result<Vec<Keyframe>, LoadError> {
    // Error messages show example keyframes. The examples have values of the type that the target
    // needs.
    let key = example_key(named.kind);
    let value = table
        .need("keys")
        .map_err(|error| error.help(format!("add `{}`", example(key))))?;
    let value = Value { key, ..value };
    let keys = value.list("a list of keyframes [time, value]")?;
    if keys.is_empty() {
        return Err(value.error_with_example("must not be empty"));
    }
    if keys.len() > MAX_KEYS {
        let reason = format!("must be at most {MAX_KEYS} keyframes, not {}", keys.len());
        return Err(value.error(reason).help("remove some of them"));
    }
    keys.iter().map(|value| keyframe(value, named)).collect()
}

/// Reads a keyframe `[time, value]`.
fn keyframe(value: &Value<'_>, named: &NamedTarget) -> Result<Keyframe, LoadError> {
    let expected = match named.kind {
        ValueKind::Point => "a keyframe [time, [x, y, z]]",
        ValueKind::Color => "a keyframe [time, COLOR]",
        ValueKind::Number => "a keyframe [time, number]",
        ValueKind::Angles => "a keyframe [time, yaw] or [time, [yaw, pitch]]",
    };
    let [time, value] = value.array(expected)?;
    let is_list = matches!(value.node.get_ref(), DeValue::Array(_));
    let vector = |x, y| Vec3::new(x, y, Real::ZERO);
    let keyframe = Keyframe {
        time: time.number()?,
        value: match named.kind {
            ValueKind::Point => value.vector()?,
            ValueKind::Color => value.color().map(|c| Vec3::new(c.r, c.g, c.b))?,
            ValueKind::Angles if is_list => value
                .numbers("two angles [yaw, pitch]")
                .map(|[yaw, pitch]| vector(yaw, pitch))?,
            ValueKind::Number | ValueKind::Angles => vector(value.number()?, Real::ZERO),
        },
    };
    check_limits(&value, keyframe.value, named)?;
    Ok(keyframe)
}

/// Returns an error if a value of a keyframe is outside the limits of its target.
fn check_limits(
    value: &Value<'_>,
    vector: Vec3<Real>,
    named: &NamedTarget,
) -> Result<(), LoadError> {
    let Some([least, most]) = limits(named.target) else {
        return Ok(());
    };
    let is_within = |number: Real| (least..=most).contains(&number);
    let is_valid = match named.kind {
        ValueKind::Number => is_within(vector.x),
        _ => [vector.x, vector.y, vector.z].into_iter().all(is_within),
    };
    if is_valid {
        return Ok(());
    }
    let problem = SceneProblem::OutOfRange { least, most };
    Err(value.error_with_example(format!("{problem}, not {}", excerpt(value.source_text()))))
}

/// Returns the name under which [`example`] has keyframes with values of this type.
fn example_key(kind: ValueKind) -> &'static str {
    match kind {
        ValueKind::Point => "keys",
        ValueKind::Color => "color keys",
        ValueKind::Number => "number keys",
        ValueKind::Angles => "angle keys",
    }
}
