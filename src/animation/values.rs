//! Checks all values that tracks reach. A frame therefore cannot fail because of a value that is
//! out of range.

use super::script::{Script, ScriptTrack, set_camera, set_shape};
use super::{AnimationError, AnimationProblem, Target};
use crate::geometry::{self, Extent, limits};
use crate::math::{Color, Real, Vec3};
use crate::prepare::{self, Settings};
use crate::scene::{Camera, Light, SceneError, SceneItem, Shape};

impl Script<'_> {
    /// Checks the values against all limits that do not depend on the scale of the scene.
    pub(super) fn check_values(&self, still: &Camera) -> Result<(), AnimationError> {
        self.check_reaches(|track, reach| {
            reach
                .corners()
                .try_for_each(|value| self.check_value(track.target, value, still))
        })
    }

    /// Checks the values against the limits that the scale and the exposure of the scene set.
    pub(super) fn check_scale(&self, settings: &Settings) -> Result<(), AnimationError> {
        let brightest = Real::ONE << u32::from(settings.exposure);
        self.check_reaches(|track, reach| match track.target {
            Target::ObjectPosition(index) | Target::ObjectRadius(index) => {
                let item = SceneItem::Object(index);
                reach.corners().try_for_each(|value| {
                    let shape = self.changed_shape(index, track.target, value);
                    geometry::Shape::prepare(&shape, &settings.normalization, item).map(drop)
                })
            }
            Target::LightColor(index) => reach.corners().try_for_each(|value| {
                let limits = [Real::ZERO, brightest];
                [value.x, value.y, value.z]
                    .into_iter()
                    .try_for_each(|c| limits::range(SceneItem::Light(index), "diffuse", c, limits))
            }),
            _ => Ok(()),
        })
    }

    /// Checks that the camera can be prepared at the time of each keyframe of a camera track.
    pub(super) fn check_cameras(&self, settings: &Settings) -> Result<(), AnimationError> {
        for (track, number) in self.tracks().zip(0..=u16::MAX) {
            let (Target::CameraEye
            | Target::CameraLookAt
            | Target::CameraFovy
            | Target::CameraOrbit) = track.target
            else {
                continue;
            };
            for (key, index) in track.curve.keys.iter().zip(0..=u16::MAX) {
                let time = self.local_time(key.time);
                let camera = self.camera_at(settings.authored_camera, time);
                prepare::moved_camera(&camera, &settings.normalization)
                    .map_err(|error| AnimationProblem::Value(index, error).in_track(number))?;
            }
        }
        Ok(())
    }

    /// Calls a function with each track and each box of values between two keyframes. The error
    /// names the track and the first of the two keyframes.
    fn check_reaches(
        &self,
        check: impl Fn(&ScriptTrack<'_>, Extent) -> Result<(), SceneError>,
    ) -> Result<(), AnimationError> {
        for (track, number) in self.tracks().zip(0..=u16::MAX) {
            // Angles may have any value.
            if track.target == Target::CameraOrbit {
                continue;
            }
            for (reach, index) in track.curve.reaches().zip(0..=u16::MAX) {
                check(&track, reach)
                    .map_err(|error| AnimationProblem::Value(index, error).in_track(number))?;
            }
        }
        Ok(())
    }

    fn check_value(
        &self,
        target: Target,
        value: Vec3<Real>,
        still: &Camera,
    ) -> Result<(), SceneError> {
        const BLACK: Color<Real> = Color::gray(Real::ZERO);
        match target {
            Target::ObjectPosition(index) | Target::ObjectRadius(index) => {
                let shape = self.changed_shape(index, target, value);
                geometry::validate(&shape, SceneItem::Object(index))
            }
            Target::LightPosition(index) => {
                prepare::validate_light(SceneItem::Light(index), &Light::point(value, BLACK))
            }
            Target::LightColor(index) => {
                let Vec3 { x, y, z } = value;
                let light = Light::point(still.eye, Color::new(x, y, z));
                prepare::validate_light(SceneItem::Light(index), &light)
            }
            _ => {
                let mut camera = *still;
                set_camera(&mut camera, target, value);
                prepare::validate_camera(&camera)
            }
        }
    }

    /// Returns the shape of an object with one changed property.
    fn changed_shape(&self, object: u16, target: Target, value: Vec3<Real>) -> Shape {
        let mut shape = self.shape(object).unwrap_or(Shape::NONE);
        set_shape(&mut shape, target, value);
        shape
    }
}
