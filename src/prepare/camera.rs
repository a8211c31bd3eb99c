use super::settings::Camera;
use super::validate;
use crate::geometry::Normalization;
use crate::math::{Real, direction, tangent_of_half};
use crate::scene;
use crate::scene::{SceneError, SceneItem, SceneProblem};

fn error(field: &'static str, problem: SceneProblem) -> SceneError {
    SceneError {
        item: SceneItem::Camera,
        field,
        problem,
    }
}

/// Validates the camera of a scene and prepares it.
pub(super) fn camera(
    camera: &scene::Camera,
    normalization: &Normalization,
) -> Result<Camera, SceneError> {
    let view = camera.look_at - camera.eye;
    let forward = direction(view.map(Real::to_bits));
    let forward = forward.ok_or(error("look_at", SceneProblem::NoView))?;
    let up = direction(camera.up.map(Real::to_bits));
    let up = up.ok_or(error("up", SceneProblem::NoDirection))?;
    let right = forward.cross(up);
    // The length of `right` is the sine of the angle between the view direction and `up`, in
    // units of 2^-60.
    if right.x.abs().max(right.y.abs()).max(right.z.abs()) < 1 << 44 {
        return Err(error("up", SceneProblem::AlongView));
    }
    let right = direction(right).ok_or(error("up", SceneProblem::AlongView))?;
    let up = direction(right.cross(forward)).ok_or(error("up", SceneProblem::AlongView))?;
    Ok(Camera {
        eye: normalization.point(camera.eye),
        forward,
        right,
        up,
        tangent: tangent_of_half(camera.fovy_deg),
    })
}

/// Prepares a new camera for a scene that is already prepared.
pub(crate) fn moved_camera(
    camera: &scene::Camera,
    normalization: &Normalization,
) -> Result<Camera, SceneError> {
    validate::camera(camera)?;
    if !normalization.is_near(camera.eye) {
        return Err(error("eye", SceneProblem::OutOfReach));
    }
    self::camera(camera, normalization)
}
