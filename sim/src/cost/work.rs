use std::collections::BTreeMap;

use embedded_graphics_core::geometry::Size;
use whitted::observer::{Observer, RayKind, RayNode, ShapeKind, Stats};
use whitted::{Color, PreparedScene, Radiance, Renderer};

use crate::render;

/// What a frame asks for, that has a price of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Item {
    /// Its name in the file of the model.
    pub key: &'static str,
    /// Its name for people.
    pub title: &'static str,
}

macro_rules! items {
    ($($name:ident: $key:literal, $title:literal;)*) => {
        /// Places of the items.
        #[derive(Clone, Copy)]
        enum Place { $($name),* }

        /// All items, in the order of [`Work::amounts`].
        pub const ITEMS: [Item; [$(Place::$name),*].len()] = [
            $(Item { key: $key, title: $title }),*
        ];
    };
}

items! {
    Byte: "byte", "a byte of the compiled scene, decoded";
    Outline: "outline", "an object, looked for in a line";
    OutlineSeen: "outline_seen", "of these, one that the line may show";
    Eye: "eye_ray", "an eye ray: a pixel";
    Secondary: "secondary_ray", "a reflected or transmitted ray: a secondary one";
    Transmitted: "transmitted_ray", "of these, a transmitted one: its refraction";
    Missing: "missing_ray", "of the secondary rays, one that meets nothing";
    Sky: "sky", "a gradient, where any ray meets nothing";
    Light: "light", "a light, at a surface that reflects it";
    Highlight: "highlight", "a highlight";
    Shadow: "shadow_ray", "a shadow ray";
    Bound: "bound", "a bound, looked at by a secondary ray";
    ShadowBound: "shadow_bound", "a bound, looked at by a shadow ray";
    EyeSpherePassed: "eye_sphere_passed", "a sphere that an eye ray passes by";
    EyeSphereMet: "eye_sphere_met", "a sphere in the way of an eye ray";
    SphereTest: "sphere_test", "a sphere, looked at by a secondary ray";
    SphereBetween: "sphere_between", "a sphere, looked at by a shadow ray";
    EyePlanePassed: "eye_plane_passed", "a plane that an eye ray passes by";
    EyePlaneMet: "eye_plane_met", "a plane in the way of an eye ray";
    EyePlaneKept: "eye_plane_kept", "a plane that an eye ray meets as the one before it did";
    PlanePassed: "plane_passed", "a plane that a secondary ray passes by";
    PlaneMet: "plane_met", "a plane in the way of a secondary ray";
    PlaneBetween: "plane_between", "a plane, looked at by a shadow ray";
    PlaneHides: "plane_hides", "of these, one that is in the way";
    EllipsoidTest: "ellipsoid_test", "a test of an ellipsoid";
    CylinderTest: "cylinder_test", "a test of a cylinder";
    ConeTest: "cone_test", "a test of a cone";
    ParaboloidTest: "paraboloid_test", "a test of a paraboloid";
    QuadricMet: "quadric_met", "an ellipsoid, cylinder, cone or paraboloid in the way";
    FlakeSphere: "sphereflake_sphere", "a sphere of a sphereflake, visited";
}

/// Counts what a frame asks for.
#[derive(Clone, Debug, Default)]
pub struct Work {
    /// Rays and tests, as people like to see them.
    pub stats: Stats,
    amounts: [u64; ITEMS.len()],
    /// How many lights there are.
    lights: u64,
    /// The materials that rays meet, by their numbers.
    met: BTreeMap<u16, Met>,
    /// How many rays met nothing.
    misses: u64,
    /// What the first of them brought back.
    background: Option<Color<Radiance>>,
    /// Whether another brought back something else.
    is_gradient: bool,
    /// The ray that is under way.
    ray: Option<RayKind>,
    /// Whether the last eye ray was tested against anything.
    is_tested: bool,
}

/// A material, as far as rays meet it.
#[derive(Clone, Copy, Debug, Default)]
struct Met {
    /// How often something is seen of it there: more than black.
    visible: u64,
    /// Whether it reflects light: a shadow ray was sent from some of it.
    is_lit: bool,
}

impl Work {
    /// That of a frame, for all that the microcontroller does: it decodes the
    /// compiled scene, and draws it.
    pub fn of(scene: &PreparedScene<'_>, size: Size) -> Self {
        let mut renderer = Renderer::with_observer(scene, size, Self::new(scene));
        render::trace(&mut renderer, |_| {});
        renderer.observer().clone()
    }

    /// Before the first ray: what decoding takes.
    pub fn new(scene: &PreparedScene<'_>) -> Self {
        let lights = scene.counts().lights as u64;
        let mut work = Self {
            lights,
            ..Self::default()
        };
        work.amounts[Place::Byte as usize] = scene.encoded_len() as u64;
        work
    }

    /// How much of each item, in the order of [`ITEMS`].
    pub fn amounts(&self) -> [u64; ITEMS.len()] {
        let lit = self.met.values().filter(|met| met.is_lit);
        let mut amounts = self.amounts;
        amounts[Place::Light as usize] = self.lights * lit.map(|met| met.visible).sum::<u64>();
        if self.is_gradient {
            amounts[Place::Sky as usize] = self.misses;
        }
        amounts
    }

    fn count(&mut self, place: Place) {
        self.amounts[place as usize] += 1;
    }
}

impl Observer for Work {
    fn ray(&mut self, kind: RayKind) {
        self.stats.ray(kind);
        self.ray = Some(kind);
        match kind {
            RayKind::Camera => {
                self.count(Place::Eye);
                self.is_tested = false;
            }
            RayKind::Reflected => self.count(Place::Secondary),
            RayKind::Transmitted => {
                self.count(Place::Secondary);
                self.count(Place::Transmitted);
            }
            RayKind::Shadow => self.count(Place::Shadow),
        }
    }

    fn test(&mut self, shape: ShapeKind, met: bool) {
        use Place::*;
        self.stats.test(shape, met);
        self.is_tested |= self.ray == Some(RayKind::Camera);
        let (test, way) = match (shape, self.ray, met) {
            (ShapeKind::Sphere, Some(RayKind::Camera), true) => (EyeSphereMet, None),
            (ShapeKind::Sphere, Some(RayKind::Camera), false) => (EyeSpherePassed, None),
            (ShapeKind::Sphere, Some(RayKind::Shadow), _) => (SphereBetween, None),
            (ShapeKind::Sphere, ..) => (SphereTest, None),
            (ShapeKind::Plane, Some(RayKind::Camera), true) => (EyePlaneMet, None),
            (ShapeKind::Plane, Some(RayKind::Camera), false) => (EyePlanePassed, None),
            (ShapeKind::Plane, Some(RayKind::Shadow), _) => (PlaneBetween, Some(PlaneHides)),
            (ShapeKind::Plane, _, true) => (PlaneMet, None),
            (ShapeKind::Plane, _, false) => (PlanePassed, None),
            (ShapeKind::Ellipsoid, ..) => (EllipsoidTest, Some(QuadricMet)),
            (ShapeKind::Cylinder, ..) => (CylinderTest, Some(QuadricMet)),
            (ShapeKind::Cone, ..) => (ConeTest, Some(QuadricMet)),
            (ShapeKind::Paraboloid, ..) => (ParaboloidTest, Some(QuadricMet)),
            // What it visits pays for it.
            (ShapeKind::Sphereflake, ..) => return,
        };
        self.count(test);
        if let Some(way) = way.filter(|_| met) {
            self.count(way);
        }
    }

    fn node(&mut self, node: &RayNode) {
        let Some(material) = node.material else {
            self.misses += 1;
            if node.kind != RayKind::Camera {
                self.count(Place::Missing);
            }
            let first = *self.background.get_or_insert(node.local);
            self.is_gradient |= node.local != first;
            return;
        };
        if node.kind == RayKind::Camera && !self.is_tested {
            self.count(Place::EyePlaneKept);
        }
        let met = self.met.entry(material).or_default();
        met.visible += u64::from(node.local != Color::default());
        met.is_lit |= self.ray == Some(RayKind::Shadow);
    }
}

#[cfg(test)]
mod tests {
    use std::error::Error;
    use std::path::Path;

    use super::*;
    use crate::scene_file;

    /// The work of one of the project's scenes.
    fn work(scene: &str, size: Size) -> Result<Work, Box<dyn Error>> {
        let folder = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes"));
        let file = scene_file::load(folder.join(scene).with_extension("toml"))?;
        let mut buffer = Box::new(scene_file::Buffer::new());
        Ok(Work::of(&file.prepare(&mut buffer)?, size))
    }

    #[test]
    fn planes_are_told_apart_by_the_rays_that_look_at_them() -> Result<(), Box<dyn Error>> {
        let size = Size::new(40, 30);
        let of = |scene, place: Place| {
            Ok::<_, Box<dyn Error>>(work(scene, size)?.amounts()[place as usize])
        };
        // No line looks above the horizon for an endless floor, but any for one with edges.
        assert_eq!(of("emission_ambient", Place::EyePlanePassed)?, 0);
        assert!(of("bouncing_ball", Place::EyePlanePassed)? > 100);
        // One ray of a line finds out how far a floor is, and of each part of a line beside a ball.
        let met = of("emission_ambient", Place::EyePlaneMet)?;
        let kept = of("emission_ambient", Place::EyePlaneKept)?;
        assert!(met > 0 && kept > met, "{met} and {kept}");
        // Nothing hides what is seen from within a room, and nothing is mirrored elsewhere.
        assert_eq!(of("room", Place::PlaneHides)?, 0);
        assert!(of("room", Place::PlaneBetween)? > 100);
        assert!(of("room", Place::PlaneMet)? > 100);
        assert_eq!(of("emission_ambient", Place::PlaneMet)?, 0);
        Ok(())
    }

    #[test]
    fn a_gradient_is_told_from_one_color() -> Result<(), Box<dyn Error>> {
        let sky = |scene| {
            let work = work(scene, Size::new(40, 30))?;
            assert!(work.misses > 100);
            Ok::<_, Box<dyn Error>>(work.amounts()[Place::Sky as usize])
        };
        assert!(sky("bouncing_ball")? > 100);
        assert_eq!(sky("four_spheres")?, 0);
        Ok(())
    }

    #[test]
    fn objects_are_looked_for_in_each_line() -> Result<(), Box<dyn Error>> {
        let work = work("sunflower", Size::new(4, 60))?;
        let of = |place: Place| work.amounts()[place as usize];
        // Balls, each no more than a quarter of the picture's height.
        assert_eq!(of(Place::Outline), 48 * 60);
        assert!((48 * 2..48 * 15).contains(&of(Place::OutlineSeen)));
        assert!(of(Place::Light) > 100);
        Ok(())
    }
}
