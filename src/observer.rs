//! Watching rays without paying for it when nobody does.

use crate::math::{Color, Factor, Radiance, Real, Weight};

/// What kind of ray is traced.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RayKind {
    /// From the eye through a pixel.
    Camera,
    /// Mirrored at a surface.
    Reflected,
    /// Through a surface.
    Transmitted,
    /// Between a light and a surface.
    Shadow,
}

/// What kind of surface a ray is tested against.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ShapeKind {
    /// A sphere.
    Sphere,
    /// A plane, endless or bounded.
    Plane,
    /// An ellipsoid.
    Ellipsoid,
    /// A cylinder.
    Cylinder,
    /// A cone.
    Cone,
    /// A paraboloid.
    Paraboloid,
    /// A sphereflake.
    Sphereflake,
}

/// Is told of every ray and every intersection test.
///
/// The methods do nothing unless overridden, and `()` overrides none, so a
/// renderer without an observer has no code for it.
pub trait Observer {
    /// A ray is about to be traced.
    #[inline(always)]
    fn ray(&mut self, kind: RayKind) {
        let _ = kind;
    }

    /// The ray that was told of last was tested against an object whose bound
    /// it meets; `met` if the surface is in its way. Objects that it passes by
    /// are not told of, nor is a plane of which the ray before it tells how far
    /// it is; those looked for near and far are told of twice.
    #[inline(always)]
    fn test(&mut self, shape: ShapeKind, met: bool) {
        let _ = (shape, met);
    }

    /// A shadow ray from a light, by its number, reached the surface: what the
    /// surfaces on its way left of the light, or `None` if one is opaque. There is
    /// none where the light would not be seen. The node of that surface is told of
    /// after all its shadow rays.
    #[inline(always)]
    fn shadow(&mut self, light: u16, left: Option<Color<Real>>) {
        let _ = (light, left);
    }

    /// A ray other than a shadow ray has met a surface, or nothing. In the
    /// order of the tree: a node, all that follows from its reflected ray, all
    /// that follows from its transmitted one.
    #[inline(always)]
    fn node(&mut self, node: &RayNode) {
        let _ = node;
    }
}

/// A node of the tree of rays: where a ray ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RayNode {
    /// What kind of ray led here.
    pub kind: RayKind,
    /// How many surfaces the light met between here and the eye: 0 for the eye ray.
    pub generation: u8,
    /// The share of what is here that reaches the eye.
    pub weight: Color<Real>,
    /// The number of the object; `None` for the background.
    pub object: Option<u16>,
    /// The number of the material; `None` for the background.
    pub material: Option<u16>,
    /// Whether the ray came from behind the surface.
    pub inside: bool,
    /// The color of the place itself, without what is reflected and transmitted.
    pub local: Color<Radiance>,
}

/// A factor as a number that users know.
pub(crate) fn to_real(color: Color<Factor>) -> Color<Real> {
    color.map(Real::from_num)
}

/// The same of a weight.
pub(crate) fn weight_to_real(weight: Color<Weight>) -> Color<Real> {
    // The last step stands for 1.
    weight.map(|weight| Real::from_bits((i64::from(weight.to_bits()) + 8) >> 4 << 4))
}

impl Observer for () {}

/// Tells two observers of everything.
pub(crate) struct Pair<'o, A, B>(pub(crate) &'o mut A, pub(crate) &'o mut B);

impl<A: Observer, B: Observer> Observer for Pair<'_, A, B> {
    #[inline(always)]
    fn ray(&mut self, kind: RayKind) {
        self.0.ray(kind);
        self.1.ray(kind);
    }

    #[inline(always)]
    fn test(&mut self, shape: ShapeKind, met: bool) {
        self.0.test(shape, met);
        self.1.test(shape, met);
    }

    #[inline(always)]
    fn shadow(&mut self, light: u16, left: Option<Color<Real>>) {
        self.0.shadow(light, left);
        self.1.shadow(light, left);
    }

    #[inline(always)]
    fn node(&mut self, node: &RayNode) {
        self.0.node(node);
        self.1.node(node);
    }
}

/// How many rays there were, of any kind.
#[derive(Default)]
pub(crate) struct Rays(pub(crate) u32);

impl Observer for Rays {
    #[inline(always)]
    fn ray(&mut self, _: RayKind) {
        self.0 = self.0.wrapping_add(1);
    }
}

/// Counts rays by kind, and intersection tests.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Stats {
    /// Rays from the eye.
    pub camera: u32,
    /// Reflected rays.
    pub reflected: u32,
    /// Transmitted rays.
    pub transmitted: u32,
    /// Shadow rays.
    pub shadow: u32,
    /// Tests of a ray against an object whose bounds it meets.
    pub intersections: u64,
}

impl Observer for Stats {
    #[inline]
    fn ray(&mut self, kind: RayKind) {
        let counter = match kind {
            RayKind::Camera => &mut self.camera,
            RayKind::Reflected => &mut self.reflected,
            RayKind::Transmitted => &mut self.transmitted,
            RayKind::Shadow => &mut self.shadow,
        };
        *counter = counter.wrapping_add(1);
    }

    #[inline]
    fn test(&mut self, _: ShapeKind, _: bool) {
        self.intersections = self.intersections.wrapping_add(1);
    }
}
