use toml::de::DeValue;
use whitted::animation::{Interpolation, Keyframe};
use whitted::scene::SceneProblem;
use whitted::{Real, Vec3};

use super::error::LoadError;
use super::example::example;
use super::file_animation::{FileAnimation, FileTrack};
use super::schema::{ANIMATION, TRACK};
use super::suggest::suggestion;
use super::table::Table;
use super::target::{NamedTarget, ValueKind, limits};
use super::value::Value;
use crate::text::excerpt;

/// Largest number of keyframes of a track.
const MAX_KEYS: usize = u16::MAX as usize;

/// Reads the table `[animation]`.
///
/// This function does not check the order and range of keyframe times. The library checks them
/// after the whole scene is read.
pub(super) fn animation(
    value: &Value<'_>,
    targets: &[NamedTarget],
) -> Result<FileAnimation, LoadError> {
    let table = Table::open(value, ANIMATION)?;
    let mut tracks: Vec<FileTrack> = Vec::new();
    for value in table
        .need("tracks")?
        .list("an array of tables in double brackets")?
    {
        let track_table = Table::open(&value, TRACK)?;
        let track = track(&track_table, targets)?;
        if tracks.iter().any(|other| other.target == track.target) {
            return Err(track_table
                .need("target")?
                .error("already has a track")
                .help("put all keyframes of a target into one track"));
        }
        tracks.push(track);
    }
    Ok(FileAnimation {
        duration: table.need("duration")?.number()?,
        looping: table
            .get("loop")
            .map_or(Ok(true), |value| value.boolean())?,
        tracks,
    })
}

fn track(table: &Table<'_>, targets: &[NamedTarget]) -> Result<FileTrack, LoadError> {
    let choices = [
        ("linear", Interpolation::Linear),
        ("smooth", Interpolation::Smooth),
    ];
    let named = find_target(&table.need("target")?, targets)?;
    let interpolation = match table.get("interpolation") {
        Some(value) => value.choice(&choices, "an interpolation", "the interpolations are")?,
        None => Interpolation::default(),
    };
    Ok(FileTrack {
        target: named.target,
        interpolation,
        keys: keyframes(table, named)?,
    })
}

fn keyframes(table: &Table<'_>, named: &NamedTarget) -> Result<Vec<Keyframe>, LoadError> {
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

fn find_target<'t>(
    value: &Value<'_>,
    targets: &'t [NamedTarget],
) -> Result<&'t NamedTarget, LoadError> {
    let text = value.text("a string")?;
    if let Some(found) = targets.iter().find(|named| named.path == text) {
        return Ok(found);
    }
    let error = value.error(format!("`{}` is not an animation target", excerpt(text)));
    let list = text.split('.').next().unwrap_or_default();
    let is_in_list = |named: &NamedTarget| named.path.split('.').next() == Some(list);
    if ["objects", "lights"].contains(&list) && !targets.iter().any(is_in_list) {
        let example = if list == "objects" { "ball" } else { "sun" };
        return Err(error.help(format!(
            "only named {list} can be animated: write `name = \"{example}\"` under [[{list}]]"
        )));
    }
    let paths = targets.iter().map(|named| named.path.as_str());
    Err(error.help(suggestion(text, paths, "the targets are")))
}

/// Reads a keyframe `[time, value]`.
fn keyframe(value: &Value<'_>, named: &NamedTarget) -> Result<Keyframe, LoadError> {
    let expected = match named.kind {
        ValueKind::Point => "a keyframe [time, [x, y, z]]",
        ValueKind::Color => "a keyframe [time, [r, g, b]]",
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
