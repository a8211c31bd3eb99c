use toml::de::DeValue;
use whitted::animation::{Interpolation, Keyframe};
use whitted::{Real, Vec3};

use super::error::LoadError;
use super::example::example;
use super::keys::{Keys, Kind};
use super::motion::{Motion, Move};
use super::nearest::advice;
use super::target::{Form, Named};
use super::value::Value;

const ANIMATION: Kind = Kind {
    name: "an animation",
    keys: &["duration", "loop", "tracks"],
};

const TRACK: Kind = Kind {
    name: "a track",
    keys: &["target", "interpolation", "keys"],
};

/// Reads `[animation]`. That keys are in order, and within the duration, is
/// checked by the library, once the scene is known.
pub(super) fn animation(value: &Value<'_>, targets: &[Named]) -> Result<Motion, LoadError> {
    let keys = Keys::of(value, "a table")?;
    keys.only(ANIMATION)?;
    let mut moved = Vec::new();
    let mut tracks = Vec::new();
    let need = keys.need("tracks", ANIMATION.name)?;
    for value in need.list("a list of tables with double brackets")? {
        let track = track(&value, targets)?;
        if moved.contains(&track.target) {
            let keys = Keys::of(&value, "a table")?;
            let error = keys.need("target", TRACK.name)?.error("is moved twice");
            return Err(error.help("put all its keys into one track"));
        }
        moved.push(track.target);
        tracks.push(track);
    }
    Ok(Motion {
        duration: keys.need("duration", ANIMATION.name)?.number()?,
        looping: keys.get("loop").map_or(Ok(true), |value| value.flag())?,
        moves: tracks,
    })
}

fn track(value: &Value<'_>, targets: &[Named]) -> Result<Move, LoadError> {
    let keys = Keys::of(value, "a table")?;
    keys.only(TRACK)?;
    let choices = [
        ("linear", Interpolation::Linear),
        ("smooth", Interpolation::Smooth),
    ];
    let named = target(&keys.need("target", TRACK.name)?, targets)?;
    let interpolation = match keys.get("interpolation") {
        Some(value) => value.choice(&choices, "a way to get from key to key", "the ways are")?,
        None => Interpolation::default(),
    };
    let example_key = example_key(named.form);
    let list = Value {
        key: example_key,
        ..keys
            .need("keys", TRACK.name)
            .map_err(|error| error.help(format!("add `{}`", example(example_key))))?
    };
    let keys = list.list("a list of keys [time, value]")?;
    if keys.is_empty() {
        return Err(list.advise("must not be empty"));
    }
    Ok(Move {
        target: named.target,
        interpolation,
        keys: keys
            .iter()
            .map(|value| key(value, named.form))
            .collect::<Result<_, _>>()?,
    })
}

fn target<'t>(value: &Value<'_>, targets: &'t [Named]) -> Result<&'t Named, LoadError> {
    let text = value.text("a string")?;
    if let Some(found) = targets.iter().find(|named| named.name == text) {
        return Ok(found);
    }
    let error = value.error(format!("`{text}` is nothing that moves"));
    let kind = text.split('.').next().unwrap_or_default();
    let is_named = |named: &Named| named.name.split('.').next() == Some(kind);
    if ["objects", "lights"].contains(&kind) && !targets.iter().any(is_named) {
        let key = if kind == "objects" { "ball" } else { "sun" };
        return Err(error.help(format!(
            "name one of the {kind}: write `name = \"{key}\"` under its [[{kind}]]"
        )));
    }
    let names = targets.iter().map(|named| named.name.as_str());
    Err(error.help(advice(text, names, "what can move is")))
}

/// `[time, value]`
fn key(value: &Value<'_>, form: Form) -> Result<Keyframe, LoadError> {
    let what = match form {
        Form::Point => "a key [time, [x, y, z]]",
        Form::Color => "a key [time, [r, g, b]]",
        Form::Number => "a key [time, number]",
        Form::Angles => "a key [time, yaw] or [time, [yaw, pitch]]",
    };
    let [time, value] = value.array(what)?;
    let is_list = matches!(value.node.get_ref(), DeValue::Array(_));
    let flat = |x, y| Vec3::new(x, y, Real::ZERO);
    Ok(Keyframe {
        time: time.number()?,
        value: match form {
            Form::Point => value.vector()?,
            Form::Color => value.color().map(|c| Vec3::new(c.r, c.g, c.b))?,
            Form::Angles if is_list => value
                .numbers("two angles [yaw, pitch]")
                .map(|[yaw, pitch]| flat(yaw, pitch))?,
            Form::Number | Form::Angles => flat(value.number()?, Real::ZERO),
        },
    })
}

fn example_key(form: Form) -> &'static str {
    match form {
        Form::Point => "keys",
        Form::Color => "keys of colors",
        Form::Number => "keys of numbers",
        Form::Angles => "keys of angles",
    }
}
