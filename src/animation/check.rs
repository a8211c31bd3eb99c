use super::script::Script;
use super::{Animation, AnimationError, AnimationProblem, Target};
use crate::math::Real;
use crate::scene::{Scene, SceneCounts};

/// The longest duration of an animation is 2^24 seconds, about half a year.
const MAX_DURATION: Real = Real::lit("16777216");

impl Animation<'_> {
    /// Checks the duration, the times of the keyframes and the targets of the tracks.
    /// [`SceneBuffer::prepare_animation`](crate::SceneBuffer::prepare_animation) also does this
    /// check, and then checks the values of the keyframes.
    ///
    /// # Errors
    /// Returns an error for the first track with invalid keyframes or an invalid target, or for
    /// an invalid duration.
    pub fn check(&self, scene: &Scene<'_>) -> Result<(), AnimationError> {
        let counts = SceneCounts::EMPTY
            .objects(scene.objects.len())
            .lights(scene.lights.len());
        Script::authored(scene, self).check(&counts)
    }
}

impl Script<'_> {
    /// Checks the duration, the times of the keyframes and the targets of the tracks. `counts` has
    /// the numbers of objects and lights of the scene.
    pub(super) fn check(&self, counts: &SceneCounts) -> Result<(), AnimationError> {
        if self.duration <= 0 || self.duration > MAX_DURATION {
            return Err(AnimationProblem::Duration.in_animation());
        }
        if u16::try_from(self.tracks().count()).is_err() {
            return Err(AnimationProblem::TooManyTracks.in_animation());
        }
        for (track, number) in self.tracks().zip(0..=u16::MAX) {
            let keys = track.curve.keys.check(self.duration);
            keys.and_then(|()| self.check_target(track.target, counts))
                .map_err(|problem| problem.in_track(number))?;
        }
        Ok(())
    }

    fn check_target(&self, target: Target, counts: &SceneCounts) -> Result<(), AnimationProblem> {
        match target {
            Target::ObjectPosition(number) | Target::ObjectRadius(number) => {
                let is_known = usize::from(number) < counts.objects;
                let shape = self.shape(number).filter(|_| is_known);
                let shape = shape.ok_or(AnimationProblem::NoSuchObject(number))?;
                if matches!(target, Target::ObjectRadius(_)) && !shape.has_radius() {
                    return Err(AnimationProblem::NoRadius(number));
                }
            }
            Target::LightPosition(number) | Target::LightColor(number)
                if usize::from(number) >= counts.lights =>
            {
                return Err(AnimationProblem::NoSuchLight(number));
            }
            _ => {}
        }
        Ok(())
    }
}
