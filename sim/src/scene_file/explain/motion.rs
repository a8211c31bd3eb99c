use whitted::animation::{AnimationError, AnimationProblem, Target};
use whitted::scene::SceneItem;
use whitted::{Real, SceneError};

use crate::scene_file::error::LoadError;
use crate::scene_file::example::example;
use crate::scene_file::file::SceneFile;

impl SceneFile {
    /// Leads an error in an animation back to its key.
    pub(in crate::scene_file) fn explain_animation(&self, error: AnimationError) -> LoadError {
        let keys = match error.track {
            Some(track) => format!("animation.tracks[{track}].keys"),
            None => "animation.duration".to_owned(),
        };
        let key = |index: u16| format!("{keys}[{index}]");
        match error.problem {
            AnimationProblem::Duration => self
                .wrong(keys, "must be above 0, at most 16777216 seconds")
                .help(format!("write for example `{}`", example("duration"))),
            AnimationProblem::Unsorted(index) => self
                .wrong(key(index), "is before the key above it")
                .help("put keys in the order of their times"),
            AnimationProblem::Crowded(index) => self
                .wrong(key(index), "is the third key of its time")
                .help("two are a jump or a corner; leave the others out"),
            AnimationProblem::OutsideDuration(index) => self
                .wrong(key(index), "is not within the duration")
                .help("give it a time from 0 to `duration`, or make that longer"),
            problem => self.wrong(keys, problem.to_string()),
        }
    }

    /// Leads what is wrong with a frame back to the track that made it so, or
    /// else to what is still.
    pub fn explain_frame(&self, error: SceneError, time: Real) -> LoadError {
        let mut moves = self.animation.iter().flat_map(|motion| &motion.moves);
        if let Some(track) = moves.position(|track| is_about(&error, track.target)) {
            let reason = format!("at {time:.3} s, {} {}", error.field, error.problem);
            return self.wrong(format!("animation.tracks[{track}].keys"), reason);
        }
        let still = self.explain(error);
        LoadError {
            reason: format!("at {time:.3} s, {}", still.reason),
            ..still
        }
    }

    fn wrong(&self, key: String, reason: impl Into<String>) -> LoadError {
        LoadError {
            file: self.outline.name().to_owned(),
            line: self.outline.find(&key).map(|entry| entry.line),
            key: Some(key),
            reason: reason.into(),
            help: None,
        }
    }
}

/// Whether an error may come from moving a target.
fn is_about(error: &SceneError, target: Target) -> bool {
    let SceneError { item, field, .. } = *error;
    match target {
        Target::CameraOrbit => item == SceneItem::Camera,
        Target::CameraEye => item == SceneItem::Camera && field == "eye",
        Target::CameraLookAt => item == SceneItem::Camera && field == "look_at",
        Target::CameraFovy => item == SceneItem::Camera && field == "fovy_deg",
        Target::ObjectPosition(object) => item == SceneItem::Object(object) && field != "radius",
        Target::ObjectRadius(object) => item == SceneItem::Object(object) && field == "radius",
        Target::LightPosition(light) => item == SceneItem::Light(light) && field == "position",
        Target::LightColor(light) => item == SceneItem::Light(light) && field != "position",
        _ => false,
    }
}
