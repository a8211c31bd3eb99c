use crate::observer::{Observer, RayKind, ShapeKind};

/// Counts rays by their kind, and counts intersection tests.
///
/// ```
/// use embedded_graphics::prelude::*;
/// use whitted::observer::Stats;
/// use whitted::{Camera, Renderer, Scene, SceneBuffer, real, vec3};
///
/// let camera = Camera::new(vec3!(0, 2, 8), vec3!(0, 1, 0), real!(33));
/// let mut buffer = SceneBuffer::<1, 1, 1>::new();
/// let scene = buffer.prepare(&Scene::new(camera))?;
/// let mut renderer = Renderer::with_observer(&scene, Size::new(32, 24), Stats::default());
/// renderer.pixel(16, 12);
/// assert_eq!(renderer.observer().camera, 1);
/// # Ok::<(), whitted::SceneError>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Stats {
    /// Number of camera rays.
    pub camera: u32,
    /// Number of reflected rays.
    pub reflected: u32,
    /// Number of transmitted rays.
    pub transmitted: u32,
    /// Number of shadow rays.
    pub shadow: u32,
    /// Number of calls of [`Observer::test`].
    pub intersections: u64,
}

impl Observer for Stats {
    const OBSERVES_NODES: bool = false;

    fn ray(&mut self, kind: RayKind) {
        let counter = match kind {
            RayKind::Camera => &mut self.camera,
            RayKind::Reflected => &mut self.reflected,
            RayKind::Transmitted => &mut self.transmitted,
            RayKind::Shadow => &mut self.shadow,
        };
        *counter = counter.wrapping_add(1);
    }

    fn test(&mut self, _: ShapeKind, _: bool) {
        self.intersections = self.intersections.wrapping_add(1);
    }
}

/// Counts rays of all kinds together.
#[derive(Default)]
pub(crate) struct RayCounter(pub(crate) u32);

impl Observer for RayCounter {
    const OBSERVES_NODES: bool = false;

    fn ray(&mut self, _: RayKind) {
        self.0 = self.0.wrapping_add(1);
    }
}
