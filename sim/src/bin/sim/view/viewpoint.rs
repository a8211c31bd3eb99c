use whitted::{Camera, PreparedScene, Real, SceneError, real};

/// Camera movement relative to the scene's camera.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Viewpoint {
    /// Orbit to the right, in degrees.
    pub(super) yaw: i32,
    /// Orbit upward, in degrees.
    pub(super) pitch: i32,
    /// Number of zoom steps. A step changes the field of view by a tenth of its value.
    pub(super) zoom: i32,
}

impl Viewpoint {
    /// Angle by which one key press moves the camera, in degrees.
    pub(super) const STEP: i32 = 5;

    /// Moves the camera of a scene.
    pub(super) fn apply(self, scene: &mut PreparedScene<'_>) -> Result<(), SceneError> {
        if self != Self::default() {
            scene.set_camera(&self.moved(scene.camera()))?;
        }
        Ok(())
    }

    fn moved(self, camera: Camera) -> Camera {
        let [yaw, pitch] = [self.yaw, self.pitch].map(Real::from);
        let mut camera = camera.orbited(yaw, pitch);
        let (tenth, narrowest, widest) = (real!(0.1), Real::ONE, real!(170));
        for _ in 0..self.zoom.abs() {
            let step = camera.fovy_deg * tenth * Real::from(-self.zoom.signum());
            camera.fovy_deg = (camera.fovy_deg + step).clamp(narrowest, widest);
        }
        camera
    }
}

#[cfg(test)]
mod tests {
    use whitted::vec3;

    use super::*;

    #[test]
    fn orbits_and_zooms() {
        let eye = vec3!(0, 1, 8);
        let camera = Camera::new(eye, vec3!(0, 1, 0), real!(50));
        let right = Viewpoint {
            yaw: 90,
            ..Viewpoint::default()
        };
        assert_eq!(right.moved(camera).eye, vec3!(8, 1, 0));
        let zooms = |zoom| Viewpoint {
            zoom,
            ..Viewpoint::default()
        };
        let angle = |zoom| zooms(zoom).moved(camera).fovy_deg.to_num::<f32>();
        assert!((angle(2) - 40.5).abs() < 1e-3);
        assert!((angle(-1) - 55.0).abs() < 1e-3);
        assert_eq!([angle(999), angle(-999)], [1.0, 170.0]);
    }
}
