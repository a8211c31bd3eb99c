use core::fmt;

use super::script::{Script, ScriptTrack};
use super::{Animation, AnimationError, AnimationProblem, Target};
use crate::codec::{self, Content};
use crate::geometry::Shape;
use crate::math::{Color, Real, Vec3};
use crate::prepare::{self, PreparedScene, SceneLists, SceneSink, Settings};
use crate::scene::{DecodeError, Scene, SceneCounts, SceneError, SceneItem, SceneProblem};

/// An animated scene that is ready to be played, in the memory of a
/// [`SceneBuffer`](crate::SceneBuffer).
///
/// [`SceneBuffer::prepare_animation`](crate::SceneBuffer::prepare_animation) and
/// [`SceneBuffer::decode_animation`](crate::SceneBuffer::decode_animation) return it. Each frame is
/// computed from the scene before animation. Rounding errors therefore do not accumulate, and
/// frames can be requested in any order. All frames have the same scale. A frame of a compiled
/// scene equals the frame of its source, bit for bit.
///
/// ```
/// use whitted::animation::{Animation, Interpolation, Keyframe, Target, Track};
/// use whitted::{
///     Camera, Color, Light, Material, MaterialId, Object, Real, Scene, SceneBuffer, color, real, vec3,
/// };
///
/// static SCENE: Scene = Scene {
///     lights: &[Light::point(vec3!(-6, 11, 7), Color::gray(Real::ONE))],
///     materials: &[Material { kd: color!(0.6, 0.04, 0.03), ..Material::BLACK }],
///     objects: &[Object::sphere(vec3!(0, 1, 0), Real::ONE, MaterialId(0))],
///     ..Scene::new(Camera::new(vec3!(0, 2, 8), vec3!(0, 1, 0), real!(33)))
/// };
/// static UP_AND_DOWN: Animation = Animation {
///     duration: real!(2),
///     looping: true,
///     tracks: &[Track {
///         target: Target::ObjectPosition(0),
///         interpolation: Interpolation::Smooth,
///         keys: &[
///             Keyframe::vector(real!(0), vec3!(0, 1, 0)),
///             Keyframe::vector(real!(1), vec3!(0, 2, 0)),
///             Keyframe::vector(real!(2), vec3!(0, 1, 0)),
///         ],
///     }],
/// };
///
/// let mut buffer = SceneBuffer::<1, 1, 1>::new();
/// let mut animation = buffer.prepare_animation(&SCENE, &UP_AND_DOWN)?;
/// for frame in 0..20 {
///     let scene = animation.frame(Real::from(frame) / 10)?;
///     // Renderer::new(&scene, display.size()).draw(&mut display)
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct PreparedAnimation<'b> {
    lists: SceneLists<'b>,
    settings: Settings,
    script: Script<'b>,
}

/// Validates a scene and its animation, and prepares the scene with the scale of the animation.
#[inline(never)]
pub(crate) fn prepare<'b>(
    scene: &Scene<'b>,
    animation: &Animation<'b>,
    sink: &mut impl SceneSink,
) -> Result<(Settings, Script<'b>), AnimationError> {
    let script = Script::authored(scene, animation);
    sink.clear();
    prepare::validate_scene(scene)?;
    animation.check(scene)?;
    script.check_values(&scene.camera)?;
    let normalization = script.normalization(scene);
    let exposure = prepare::exposure(scene, |index, light| script.brightest(index, light));
    let settings = prepare::prepare_scaled(scene, normalization, exposure, sink)?;
    script.check_scale(&settings)?;
    script.check_cameras(&settings)?;
    Ok((settings, script))
}

/// Decodes a compiled scene and its animation, and validates all values.
#[inline(never)]
pub(crate) fn decode<'b>(
    bytes: &'b [u8],
    sink: &mut impl SceneSink,
) -> Result<(Settings, Script<'b>), DecodeError> {
    let (settings, section) = codec::decode(bytes, sink)?;
    let Some(section) = section else {
        return Ok((settings, Script::STILL));
    };
    let script = Script::decode(section).ok_or(DecodeError::Length)?;
    script
        .validate(&settings, &SceneCounts::of_compiled(bytes))
        .map_err(|error| match error.problem {
            AnimationProblem::Value(_, error) => invalid(error),
            _ => DecodeError::InvalidAnimation,
        })?;
    if !script.is_within(&settings.normalization, &settings.authored_camera) {
        return Err(DecodeError::InvalidAnimation);
    }
    Ok((settings, script))
}

impl Script<'_> {
    /// Validates a decoded script.
    fn validate(&self, settings: &Settings, counts: &SceneCounts) -> Result<(), AnimationError> {
        self.check(counts)?;
        prepare::validate_camera(&settings.authored_camera)?;
        self.check_values(&settings.authored_camera)?;
        self.check_scale(settings)
    }
}

fn invalid(error: SceneError) -> DecodeError {
    match error.problem {
        SceneProblem::MissingFeature(feature) => DecodeError::MissingFeature(feature),
        _ => DecodeError::InvalidAnimation,
    }
}

impl<'b> PreparedAnimation<'b> {
    pub(crate) fn new(lists: SceneLists<'b>, settings: Settings, script: Script<'b>) -> Self {
        Self {
            lists,
            settings,
            script,
        }
    }

    /// Returns true if the scene has tracks. If it has none, all frames are equal.
    pub fn is_animated(&self) -> bool {
        self.script.tracks().next().is_some()
    }

    /// Returns the duration of the animation in seconds, or 0 if the scene has no animation.
    pub fn duration(&self) -> Real {
        self.script.duration
    }

    /// Returns true if the animation repeats. If it does not repeat, the scene keeps its final
    /// state after the end.
    pub fn is_looping(&self) -> bool {
        self.script.looping
    }

    /// Returns the numbers of objects, lights and materials.
    pub fn counts(&self) -> SceneCounts {
        SceneCounts::EMPTY
            .objects(self.lists.objects.len())
            .lights(self.lists.lights.len())
            .materials(self.lists.materials.len())
    }

    /// Returns the scene at `time`, in seconds. Any time is valid.
    ///
    /// # Errors
    /// Returns an error if the camera has no direction at this time: if its eye passes through the
    /// point that it looks at, or if it looks along its `up` vector. Between keyframes, preparing
    /// and decoding do not check this.
    pub fn frame(&mut self, time: Real) -> Result<PreparedScene<'_>, SceneError> {
        let time = self.script.local_time(time);
        for track in self.script.tracks() {
            self.move_item(&track, time)?;
        }
        let camera = self.script.camera_at(self.settings.authored_camera, time);
        let mut scene = PreparedScene::new(self.lists.reborrow(), self.settings);
        if camera != self.settings.authored_camera {
            scene.set_camera(&camera)?;
        }
        Ok(scene)
    }

    /// Gives the object or light of a track its state at a time within the duration.
    fn move_item(&mut self, track: &ScriptTrack<'_>, time: Real) -> Result<(), SceneError> {
        let normalization = &self.settings.normalization;
        match track.target {
            Target::ObjectPosition(index) | Target::ObjectRadius(index) => {
                let object = self.lists.objects.get_mut(usize::from(index));
                if let (Some(object), Some(shape)) = (object, self.script.shape_at(index, time)) {
                    let item = SceneItem::Object(index);
                    object.set_shape(Shape::prepare(&shape, normalization, item)?);
                }
            }
            Target::LightPosition(index) => {
                if let Some(light) = self.lists.lights.get_mut(usize::from(index)) {
                    light.position = normalization.point(track.curve.value(time));
                }
            }
            Target::LightColor(index) => {
                if let Some(light) = self.lists.lights.get_mut(usize::from(index)) {
                    let Vec3 { x, y, z } = track.curve.value(time);
                    light.set_color(Color::new(x, y, z), self.settings.exposure);
                }
            }
            _ => {}
        }
        Ok(())
    }

    /// Returns the number of bytes that [`encode`](Self::encode) writes.
    pub fn encoded_len(&self) -> usize {
        codec::encoded_len(self.content(), self.section())
    }

    /// Writes the scene and its animation as bytes that
    /// [`SceneBuffer::decode_animation`](crate::SceneBuffer::decode_animation) can read. Returns
    /// the number of bytes, or `None` if `out` is too short.
    ///
    /// [`SceneBuffer::decode`](crate::SceneBuffer::decode) can also read the bytes. It returns the
    /// last frame that was requested before encoding, with the camera before animation. If no frame
    /// was requested, it returns the scene before animation.
    pub fn encode(&self, out: &mut [u8]) -> Option<usize> {
        codec::encode(self.content(), self.section(), out)
    }

    /// Returns the script, unless the scene has no animation.
    fn section(&self) -> Option<&Script<'b>> {
        Some(&self.script).filter(|script| script.duration > 0)
    }

    fn content(&self) -> Content<'_> {
        Content {
            settings: &self.settings,
            lights: self.lists.lights,
            materials: self.lists.materials,
            objects: self.lists.objects,
        }
    }
}

impl fmt::Debug for PreparedAnimation<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("PreparedAnimation")
            .field("duration", &self.script.duration)
            .field("looping", &self.script.looping)
            .finish_non_exhaustive()
    }
}
