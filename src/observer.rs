//! Callbacks that report rays, intersection tests, shadow rays and nodes of the ray tree.
//!
//! A renderer is generic over its [`Observer`]. The default observer, `()`, ignores all
//! callbacks, and the compiler removes the calls. A [`Poller`] calls a function after every so many
//! rays and tests, for example to feed a watchdog.

mod pair;
mod poller;
mod stats;

pub(crate) use pair::Pair;
pub use poller::Poller;
pub(crate) use stats::RayCounter;
pub use stats::Stats;

use crate::math::{Color, Factor, Radiance, Real, Weight};

/// Kind of a ray.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RayKind {
    /// A camera ray, from the eye through a pixel.
    Camera,
    /// A ray that is reflected by a surface.
    Reflected,
    /// A ray that is refracted and transmitted by a surface.
    Transmitted,
    /// A ray between a surface and a light.
    Shadow,
}

/// Kind of surface that a ray is tested against.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ShapeKind {
    /// A sphere.
    Sphere,
    /// A plane, unbounded or clipped.
    Plane,
    /// An ellipsoid.
    Ellipsoid,
    /// A cylinder.
    Cylinder,
    /// A cone.
    Cone,
    /// A paraboloid.
    Paraboloid,
    /// A sphere of a sphereflake.
    Sphereflake,
}

/// Receives the rays and intersection tests of a renderer.
///
/// By default, every method does nothing.
///
/// ```
/// use embedded_graphics::prelude::*;
/// use whitted::observer::{Observer, RayNode};
/// use whitted::{Camera, Renderer, Scene, SceneBuffer, real, vec3};
///
/// /// Counts the rays that miss every object.
/// #[derive(Default)]
/// struct Misses(u32);
///
/// impl Observer for Misses {
///     fn node(&mut self, node: &RayNode) {
///         self.0 += u32::from(node.object.is_none());
///     }
/// }
///
/// let camera = Camera::new(vec3!(0, 2, 8), vec3!(0, 1, 0), real!(33));
/// let mut buffer = SceneBuffer::<1, 1, 1>::new();
/// let scene = buffer.prepare(&Scene::new(camera))?;
/// let mut renderer = Renderer::with_observer(&scene, Size::new(32, 24), Misses::default());
/// assert_eq!(renderer.line(0).count(), 32);
/// assert_eq!(renderer.observer().0, 32);
/// # Ok::<(), whitted::SceneError>(())
/// ```
pub trait Observer {
    /// Set this to false if [`node`](Self::node) does nothing. The renderer then does not
    /// compute the argument of `node`.
    const OBSERVES_NODES: bool = true;

    /// Called before a ray is traced.
    fn ray(&mut self, kind: RayKind) {
        let _ = kind;
    }

    /// Called after the current ray was tested against an object. `met` is true if the ray hits
    /// the surface of the object.
    ///
    /// Nothing is reported if the ray misses the bounding sphere of the object. Nothing is
    /// reported for a plane if the renderer reuses the distance of the plane from the previous
    /// ray. An object is reported twice if it is tested both in the near range, where
    /// coordinates are within ±3.5, and in the extended range. For a sphereflake, one test is
    /// reported for each visited sphere.
    fn test(&mut self, shape: ShapeKind, met: bool) {
        let _ = (shape, met);
    }

    /// Called after a shadow ray to light number `light` was traced.
    ///
    /// `transmittance` is the fraction of the light that reaches the surface, from 0 to 1 per
    /// channel. It is `None` if an opaque surface occludes the light. No shadow ray is traced
    /// to a light that cannot contribute to the color of the surface. All shadow rays of a
    /// surface are reported before the [`node`](Self::node) of the surface.
    fn shadow(&mut self, light: u16, transmittance: Option<Color<Real>>) {
        let _ = (light, transmittance);
    }

    /// Called after a camera, reflected or transmitted ray has hit a surface or the background.
    ///
    /// The nodes of a ray tree are reported depth first: first a node, then the subtree of its
    /// reflected ray, then the subtree of its transmitted ray.
    fn node(&mut self, node: &RayNode) {
        let _ = node;
    }

    /// Returns true if the renderer is to stop inside the current pixel.
    ///
    /// The renderer calls this function between the rays of a pixel and between the tests of a
    /// sphereflake. If the function returns true, the renderer abandons the pixel, ends the
    /// current line before this pixel, and returns. Until then, the function must keep returning
    /// true, and at most one more test per object, and per object and light, is reported.
    ///
    /// [`Renderer::step`](crate::Renderer::step) records which pixels were drawn, so a later step
    /// can trace the abandoned pixel again and complete the picture. All other methods must be
    /// called again from the start: a line ends early, the rest of a slice is not changed, and
    /// [`Renderer::pixel`](crate::Renderer::pixel) returns black.
    fn is_interrupted(&self) -> bool {
        false
    }
}

/// A node of the ray tree: the surface or background at the end of a ray.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RayNode {
    /// Kind of the ray that ends here.
    pub kind: RayKind,
    /// Number of surfaces on the path between this node and the eye. The number is 0 for a
    /// camera ray.
    pub generation: u8,
    /// Fraction of this node's radiance that reaches the eye, 0 to 1 per channel.
    pub weight: Color<Real>,
    /// Number of the object that the ray hit. `None` for the background.
    pub object: Option<u16>,
    /// Number of the material at the hit. `None` for the background.
    pub material: Option<u16>,
    /// True if the ray hit the surface from behind.
    pub inside: bool,
    /// Radiance of the surface itself, without the contributions of its reflected and
    /// transmitted rays.
    pub local: Color<Radiance>,
}

/// Converts a color from factors to [`Real`] numbers, which the public API uses. The conversion
/// is exact.
pub(crate) fn to_real(color: Color<Factor>) -> Color<Real> {
    color.map(Real::from_num)
}

/// Converts a color of weights to numbers of the public API. The conversion rounds, so that the
/// greatest weight becomes 1.
pub(crate) fn weight_to_real(weight: Color<Weight>) -> Color<Real> {
    weight.map(|weight| Real::from_bits((i64::from(weight.to_bits()) + 8) >> 4 << 4))
}

impl Observer for () {
    const OBSERVES_NODES: bool = false;
}
