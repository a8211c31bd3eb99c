use whitted::animation::Interpolation;

use super::error::LoadError;
use super::file_animation::{FileAnimation, FileTrack};
use super::keyframe::keyframes;
use super::schema::{ANIMATION, TRACK};
use super::suggest::suggestion;
use super::table::Table;
use super::target::NamedTarget;
use super::value::Value;
use crate::text::excerpt;

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
