use embedded_graphics_core::geometry::Size;
use whitted::observer::{Observer, RayKind, RayNode, ShapeKind, Stats};
use whitted::{Color, PreparedScene, Renderer};

use crate::render;

/// Names of the items of work that the cost model counts, in the order of [`Work::amounts`].
pub const ITEMS: [&str; 15] = [
    "object in a scanline",
    "camera ray",
    "reflected or transmitted ray",
    "refraction",
    "shadow ray",
    "bounding sphere of a reflected or transmitted ray",
    "bounding cone of a shadow ray",
    "light at a surface",
    "sphere test",
    "plane test",
    "ellipsoid test",
    "cylinder test",
    "cone test",
    "paraboloid test",
    "sphere of a sphereflake",
];

/// An item of work. Its discriminant is the index of its name in [`ITEMS`].
#[derive(Clone, Copy)]
enum Item {
    ObjectInLine,
    CameraRay,
    SecondaryRay,
    Refraction,
    ShadowRay,
    BoundingSphere,
    LightCone,
    Light,
    Sphere,
    Plane,
    Ellipsoid,
    Cylinder,
    Cone,
    Paraboloid,
    Sphereflake,
}

/// Counts the items of work in a frame.
#[derive(Clone, Debug, Default)]
pub struct Work {
    /// Numbers of rays by kind, and of intersection tests.
    pub stats: Stats,
    amounts: [u64; ITEMS.len()],
    objects: u64,
    lights: u64,
}

impl Work {
    /// Renders a frame and counts its items of work.
    pub fn of(scene: &PreparedScene<'_>, size: Size) -> Self {
        let mut renderer = Renderer::with_observer(scene, size, Self::new(scene, size));
        render::trace(&mut renderer, |_| {});
        renderer.observer().clone()
    }

    /// Creates the counter for a frame. The counter starts with one item for each object in each
    /// scanline. The other items are counted during the rendering.
    pub fn new(scene: &PreparedScene<'_>, size: Size) -> Self {
        let counts = scene.counts();
        let mut work = Self {
            objects: counts.objects as u64,
            lights: counts.lights as u64,
            ..Self::default()
        };
        work.add(Item::ObjectInLine, work.objects * u64::from(size.height));
        work
    }

    /// Returns the number of each item, in the order of [`ITEMS`].
    pub fn amounts(&self) -> [u64; ITEMS.len()] {
        self.amounts
    }

    fn add(&mut self, item: Item, amount: u64) {
        self.amounts[item as usize] += amount;
    }

    /// Returns the estimated number of bounding spheres that a secondary ray is tested against. Up
    /// to 16 objects are tested one by one. More objects are in groups of 8, and each group has its
    /// own bounding sphere. The ray is tested against the sphere of each group. On average it
    /// enters two groups, and is tested against their 16 objects.
    fn bounds(&self) -> u64 {
        match self.objects {
            0..=16 => self.objects,
            _ => self.objects.div_ceil(8) + 16,
        }
    }
}

impl Observer for Work {
    fn ray(&mut self, kind: RayKind) {
        self.stats.ray(kind);
        match kind {
            RayKind::Camera => self.add(Item::CameraRay, 1),
            RayKind::Shadow => {
                self.add(Item::ShadowRay, 1);
                self.add(Item::LightCone, self.objects);
            }
            RayKind::Reflected | RayKind::Transmitted => {
                self.add(Item::SecondaryRay, 1);
                self.add(Item::BoundingSphere, self.bounds());
            }
        }
        if kind == RayKind::Transmitted {
            self.add(Item::Refraction, 1);
        }
    }

    fn test(&mut self, shape: ShapeKind, met: bool) {
        self.stats.test(shape, met);
        let item = match shape {
            ShapeKind::Sphere => Item::Sphere,
            ShapeKind::Plane => Item::Plane,
            ShapeKind::Ellipsoid => Item::Ellipsoid,
            ShapeKind::Cylinder => Item::Cylinder,
            ShapeKind::Cone => Item::Cone,
            ShapeKind::Paraboloid => Item::Paraboloid,
            ShapeKind::Sphereflake => Item::Sphereflake,
        };
        self.add(item, 1);
    }

    fn node(&mut self, node: &RayNode) {
        if node.material.is_some() && node.local != Color::default() {
            self.add(Item::Light, self.lights);
        }
    }
}
