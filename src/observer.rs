//! Callbacks for rays, intersection tests, shadow rays and nodes of the ray tree.
//!
//! A renderer is generic over its [`Observer`]. The default observer `()` ignores every
//! callback, so the compiler removes the calls.

mod pair;
mod stats;

pub(crate) use pair::Pair;
pub(crate) use stats::RayCounter;
pub use stats::Stats;

use crate::math::{Color, Factor, Radiance, Real, Weight};

/// Kind of a ray.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RayKind {
    /// A camera ray: from the eye through a pixel.
    Camera,
    /// A ray that a surface reflects.
    Reflected,
    /// A ray that a surface transmits, refracted.
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

/// Receives every ray and intersection test of a renderer.
///
/// All methods do nothing by default.
///
/// ```
/// use embedded_graphics::prelude::*;
/// use whitted::observer::{Observer, RayNode};
/// use whitted::{Camera, Real, Renderer, Scene, SceneBuffer, Vec3};
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
/// let camera = Camera::new(Vec3::lit("0", "2", "8"), Vec3::lit("0", "1", "0"), Real::lit("33"));
/// let mut buffer = SceneBuffer::<1, 1, 1>::new();
/// let scene = buffer.prepare(&Scene::new(camera))?;
/// let mut renderer = Renderer::with_observer(&scene, Size::new(32, 24), Misses::default());
/// assert_eq!(renderer.line(0).count(), 32);
/// assert_eq!(renderer.observer().0, 32);
/// # Ok::<(), whitted::SceneError>(())
/// ```
pub trait Observer {
    /// False if [`node`](Self::node) does nothing, so that its argument need not be computed.
    const OBSERVES_NODES: bool = true;

    /// Called before a ray is traced.
    fn ray(&mut self, kind: RayKind) {
        let _ = kind;
    }

    /// Called after the current ray was tested against an object; `met` is true if the ray hits
    /// its surface.
    ///
    /// Objects that the ray's bounding sphere test rejects are not reported, nor is a plane whose
    /// distance is reused from the previous ray. An object that is tested in the near and in the
    /// extended range is reported twice. A sphereflake reports a test for each sphere it visits.
    fn test(&mut self, shape: ShapeKind, met: bool) {
        let _ = (shape, met);
    }

    /// Called after a shadow ray to light number `light` was traced.
    ///
    /// `transmittance` is the fraction of the light that arrives, 0 to 1 per channel, or `None`
    /// if an opaque surface occludes the light. No shadow ray is traced to a light that could not
    /// contribute. All shadow rays of a surface come before the [`node`](Self::node) of that
    /// surface.
    fn shadow(&mut self, light: u16, transmittance: Option<Color<Real>>) {
        let _ = (light, transmittance);
    }

    /// Called after a camera, reflected or transmitted ray has hit a surface or the background.
    ///
    /// Nodes arrive depth first: a node, the subtree of its reflected ray, the subtree of its
    /// transmitted ray.
    fn node(&mut self, node: &RayNode) {
        let _ = node;
    }
}

/// Node of the ray tree: the end of a ray.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RayNode {
    /// Kind of the ray that ends here.
    pub kind: RayKind,
    /// Number of surfaces between this node and the eye: 0 for a camera ray.
    pub generation: u8,
    /// Fraction of the radiance of this node that reaches the eye, 0 to 1 per channel.
    pub weight: Color<Real>,
    /// Number of the object; `None` for the background.
    pub object: Option<u16>,
    /// Number of the material; `None` for the background.
    pub material: Option<u16>,
    /// True if the ray hit the back of the surface.
    pub inside: bool,
    /// Radiance of the surface without its reflected and transmitted rays.
    pub local: Color<Radiance>,
}

/// Converts factors to numbers of the public API, exactly.
pub(crate) fn to_real(color: Color<Factor>) -> Color<Real> {
    color.map(Real::from_num)
}

/// Converts weights to numbers of the public API, rounded so that the greatest weight becomes 1.
pub(crate) fn weight_to_real(weight: Color<Weight>) -> Color<Real> {
    weight.map(|weight| Real::from_bits((i64::from(weight.to_bits()) + 8) >> 4 << 4))
}

impl Observer for () {
    const OBSERVES_NODES: bool = false;
}
