//! All that a frame needs to know about an animation: its tracks, and the authored shapes that
//! they change. Both are either in memory or in the bytes of a compiled scene.

mod compiled;
mod shape_list;
mod track_list;

use core::iter;

use super::{Animation, Target};
use crate::geometry::Extent;
use crate::math::{Real, Vec3};
use crate::scene::{Camera, Scene, Shape};
use shape_list::ShapeList;
use track_list::TrackList;

pub(super) use track_list::ScriptTrack;

#[derive(Clone, Copy)]
pub(crate) struct Script<'a> {
    pub(super) duration: Real,
    pub(super) looping: bool,
    shapes: ShapeList<'a>,
    tracks: TrackList<'a>,
}

impl<'a> Script<'a> {
    /// A script without tracks.
    pub(super) const STILL: Script<'static> = Script {
        duration: Real::ZERO,
        looping: false,
        shapes: ShapeList::Authored(&[]),
        tracks: TrackList::Authored(&[]),
    };

    pub(super) fn authored(scene: &Scene<'a>, animation: &Animation<'a>) -> Self {
        Self {
            duration: animation.duration,
            looping: animation.looping,
            shapes: ShapeList::Authored(scene.objects),
            tracks: TrackList::Authored(animation.tracks),
        }
    }

    pub(super) fn tracks(&self) -> impl Iterator<Item = ScriptTrack<'a>> + use<'a> {
        let period = self.looping.then_some(self.duration);
        let mut tracks = self.tracks;
        iter::from_fn(move || tracks.next(period))
    }

    /// Returns the shape of an object before animation. A compiled script has only the shapes of
    /// animated objects.
    pub(super) fn shape(&self, object: u16) -> Option<Shape> {
        self.shapes.get(object)
    }

    /// Returns the shape of an object at a time, which must be within the duration.
    pub(super) fn shape_at(&self, object: u16, time: Real) -> Option<Shape> {
        let mut shape = self.shape(object)?;
        for track in self.tracks() {
            if track.target.object() == Some(object) {
                set_shape(&mut shape, track.target, track.curve.value(time));
            }
        }
        Some(shape)
    }

    /// Returns a camera with the values that the camera tracks give it at a time, which must be
    /// within the duration.
    pub(super) fn camera_at(&self, still: Camera, time: Real) -> Camera {
        let mut camera = still;
        let mut orbit = None;
        for track in self.tracks() {
            match track.target {
                Target::CameraOrbit => orbit = Some(track.curve.value(time)),
                Target::CameraEye | Target::CameraLookAt | Target::CameraFovy => {
                    set_camera(&mut camera, track.target, track.curve.value(time));
                }
                _ => {}
            }
        }
        match orbit {
            Some(angles) => camera.orbited(angles.x, angles.y),
            None => camera,
        }
    }

    /// Maps any time to a time within the duration. A repeating animation wraps the time around.
    /// Other animations clamp the time.
    pub(super) fn local_time(&self, time: Real) -> Real {
        if self.looping {
            time.checked_rem_euclid(self.duration).unwrap_or(Real::ZERO)
        } else {
            time.max(Real::ZERO).min(self.duration)
        }
    }

    /// Returns a box that contains all values of a target, or `None` if no track has this target.
    pub(super) fn reach(&self, target: Target) -> Option<Extent> {
        let mut all: Option<Extent> = None;
        for track in self.tracks().filter(|track| track.target == target) {
            for reach in track.curve.reaches() {
                all.get_or_insert(reach).add(&reach);
            }
        }
        all
    }
}

/// Sets the property of a camera that a track animates.
pub(super) fn set_camera(camera: &mut Camera, target: Target, value: Vec3<Real>) {
    match target {
        Target::CameraEye => camera.eye = value,
        Target::CameraLookAt => camera.look_at = value,
        Target::CameraFovy => camera.fovy_deg = value.x,
        _ => {}
    }
}

/// Sets the property of a shape that a track animates.
pub(super) fn set_shape(shape: &mut Shape, target: Target, value: Vec3<Real>) {
    match target {
        Target::ObjectPosition(_) => *shape.position_mut() = value,
        Target::ObjectRadius(_) => {
            if let Some(radius) = shape.radius_mut() {
                *radius = value.x;
            }
        }
        _ => {}
    }
}
