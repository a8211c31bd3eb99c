use whitted::animation::{AnimationError, AnimationProblem, Target};
use whitted::scene::{SceneItem, SceneProblem};
use whitted::{Real, SceneError};

use super::error::LoadError;
use super::example::example;
use super::file::SceneFile;

impl SceneFile {
    /// Converts an animation error of the library to an error that names a line and a key of the
    /// scene file.
    pub(super) fn explain_animation(&self, error: AnimationError) -> LoadError {
        let keys = match error.track {
            Some(track) => format!("animation.tracks[{track}].keys"),
            None => "animation.duration".to_owned(),
        };
        let key = |index: u16| format!("{keys}[{index}]");
        match error.problem {
            AnimationProblem::Duration => self
                .error_at(keys, "must be above 0, at most 16777216 seconds")
                .help(format!("write for example `{}`", example("duration"))),
            AnimationProblem::Unsorted(index) => self
                .error_at(key(index), "is earlier than the keyframe before it")
                .help("sort the keyframes by time"),
            AnimationProblem::Crowded(index) => self
                .error_at(key(index), "is the third keyframe at one time")
                .help("keep two for a jump or a corner, and remove the others"),
            AnimationProblem::OutsideDuration(index) => self
                .error_at(key(index), "is outside the duration")
                .help("use a time from 0 to `duration`, or increase `duration`"),
            AnimationProblem::Value(index, error) => self
                .error_at(key(index), format!("{} {}", error.field, error.problem))
                .help("change this keyframe, or the curve from here to the next keyframe"),
            AnimationProblem::Scene(error) => self.explain(error),
            problem => self.error_at(keys, problem.to_string()),
        }
    }

    /// Converts an error that the library reports for the frame at `time`. The new error names the
    /// track that may be the cause, and its last keyframe before `time`. If no track may be the
    /// cause, the new error names the scene-file key of the rejected value.
    pub fn explain_frame(&self, error: SceneError, time: Real) -> LoadError {
        let mut tracks = self.animation.iter().flat_map(|it| &it.tracks).enumerate();
        if let Some((index, track)) = tracks.find(|(_, track)| may_cause(track.target, &error)) {
            let reason = format!("at {time:.3} s, {} {}", error.field, error.problem);
            let keys = format!("animation.tracks[{index}].keys");
            let before = track.keys.partition_point(|key| key.time <= time);
            return self.error_at(format!("{keys}[{}]", before.saturating_sub(1)), reason);
        }
        let error = self.explain(error);
        LoadError {
            reason: format!("at {time:.3} s, {}", error.reason),
            ..error
        }
    }

    /// Returns an error about the scene-file key with this path.
    pub(super) fn error_at(&self, key: String, reason: impl Into<String>) -> LoadError {
        LoadError {
            file: self.outline.name().to_owned(),
            line: self.outline.find(&key).map(|entry| entry.line),
            key: Some(key),
            reason: reason.into(),
            help: None,
        }
    }
}

/// Returns true if a track that animates `target` may cause the error.
fn may_cause(target: Target, error: &SceneError) -> bool {
    let SceneError {
        item,
        field,
        problem,
    } = *error;
    let is_view = matches!(problem, SceneProblem::NoView | SceneProblem::AlongView);
    match target {
        Target::CameraOrbit => item == SceneItem::Camera,
        Target::CameraEye => item == SceneItem::Camera && (is_view || field == "eye"),
        Target::CameraLookAt => item == SceneItem::Camera && (is_view || field == "look_at"),
        Target::CameraFovy => item == SceneItem::Camera && field == "fovy_deg",
        Target::ObjectPosition(object) => item == SceneItem::Object(object) && field != "radius",
        Target::ObjectRadius(object) => item == SceneItem::Object(object) && field == "radius",
        Target::LightPosition(light) => item == SceneItem::Light(light) && field == "position",
        Target::LightColor(light) => item == SceneItem::Light(light) && field != "position",
        _ => false,
    }
}
