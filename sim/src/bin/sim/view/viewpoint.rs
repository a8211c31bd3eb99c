use whitted::{Camera, PreparedScene, Real};
use whitted_sim::scene_file::Buffer;

use crate::args::Quality;
use crate::open::Scene;
use crate::outcome::Outcome;

/// How far the camera was moved from where the scene has it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Viewpoint {
    /// Degrees to the right.
    pub(super) yaw: i32,
    /// Degrees up.
    pub(super) pitch: i32,
    /// Steps of a tenth of the field of view.
    pub(super) zoom: i32,
}

impl Viewpoint {
    /// Degrees of a step around the scene.
    pub(super) const STEP: i32 = 5;

    /// The scene as it is seen from here.
    pub(super) fn prepare<'b>(
        self,
        scene: &Scene,
        quality: &Quality,
        buffer: &'b mut Buffer,
    ) -> Outcome<PreparedScene<'b>> {
        let mut prepared = scene.prepare_for(quality, buffer)?;
        if self != Self::default() {
            prepared.set_camera(&self.moved(prepared.camera()))?;
        }
        Ok(prepared)
    }

    fn moved(self, camera: Camera) -> Camera {
        let [yaw, pitch] = [self.yaw, self.pitch].map(Real::from);
        let mut camera = camera.orbited(yaw, pitch);
        let (tenth, narrowest, widest) = (Real::lit("0.1"), Real::ONE, Real::lit("170"));
        for _ in 0..self.zoom.abs() {
            let step = camera.fovy_deg * tenth * Real::from(-self.zoom.signum());
            camera.fovy_deg = (camera.fovy_deg + step).clamp(narrowest, widest);
        }
        camera
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use whitted::Vec3;

    #[test]
    fn a_camera_is_moved_and_zooms() {
        let eye = Vec3::lit("0", "1", "8");
        let camera = Camera::new(eye, Vec3::lit("0", "1", "0"), Real::lit("50"));
        let right = Viewpoint {
            yaw: 90,
            ..Viewpoint::default()
        };
        assert_eq!(right.moved(camera).eye, Vec3::lit("8", "1", "0"));
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
