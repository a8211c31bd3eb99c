use whitted::scene::{Axis, ClipBox, SpecularModel};
use whitted::{
    Background, Camera, Color, Light, Material, MaterialId, Object, Real, Scene, SceneBuffer,
    Shape, Texture, Vec3,
};

use super::bytes::Bytes;
use super::picture::draw_as_compiled;

type Buffer = SceneBuffer<6, 3, 3>;

const BRIGHTEST: Real = Real::lit("256");

/// A scene whose numbers are often at the ends of their ranges is refused, or
/// drawn; and then its compiled form is accepted, and drawn alike. Says which.
pub fn extremes(input: &[u8]) -> bool {
    let mut world = World::new(Bytes(input));
    let lists = world.lists();
    let scene = world.scene(&lists.objects);
    let scene = Scene {
        lights: &lists.lights,
        materials: &lists.materials,
        objects: &lists.objects,
        ..scene
    };
    let mut buffer = Box::new(Buffer::new());
    let prepared = match buffer.prepare(&scene) {
        Ok(prepared) => prepared,
        Err(error) => return error.to_string().is_empty(),
    };
    draw_as_compiled(&prepared);
    true
}

struct World<'a> {
    bytes: Bytes<'a>,
    /// How far coordinates go.
    reach: Real,
    /// The least size that is likely to be accepted.
    smallest: Real,
}

struct Lists {
    lights: Vec<Light>,
    materials: Vec<Material>,
    objects: Vec<Object>,
}

impl<'a> World<'a> {
    fn new(mut bytes: Bytes<'a>) -> Self {
        let least = Real::lit("0.000001");
        let most = Real::lit("16777216");
        let reach = match bytes.choice(4) {
            0 => most,
            1 => least * 64,
            _ => bytes.number(least, most),
        };
        let smallest = (reach >> 16_u32).max(least);
        Self {
            bytes,
            reach,
            smallest,
        }
    }

    fn camera(&mut self, objects: &[Object]) -> Camera {
        let Self { bytes, reach, .. } = self;
        // Mostly there is something to be seen.
        let look_at = match objects {
            [first, ..] if bytes.choice(4) != 0 => place(&first.shape),
            _ => bytes.point(*reach),
        };
        Camera {
            eye: bytes.point(*reach),
            look_at,
            up: bytes.point(Real::lit("16777216")),
            fovy_deg: bytes.number(Real::lit("1"), Real::lit("170")),
        }
    }

    fn scene(&mut self, objects: &[Object]) -> Scene<'static> {
        let camera = self.camera(objects);
        let bytes = &mut self.bytes;
        let background = match bytes.choice(2) {
            0 => Background::Solid(bytes.color(BRIGHTEST)),
            _ => Background::Gradient {
                horizon: bytes.color(BRIGHTEST),
                zenith: bytes.color(BRIGHTEST),
            },
        };
        Scene {
            ambient: bytes.color(BRIGHTEST),
            background,
            shading: [SpecularModel::Phong, SpecularModel::BlinnPhong]
                [usize::from(bytes.choice(2))],
            max_depth: [32, 0, 1, bytes.choice(33)][usize::from(bytes.choice(4))],
            min_weight: match bytes.choice(2) {
                0 => Real::ZERO,
                _ => bytes.number(Real::ZERO, Real::ONE),
            },
            ..Scene::new(camera)
        }
    }

    fn lists(&mut self) -> Lists {
        let materials = 1 + self.bytes.choice(3);
        let lights = self.bytes.choice(4);
        let objects = 1 + self.bytes.choice(6);
        Lists {
            materials: (0..materials).map(|_| self.material()).collect(),
            lights: (0..lights).map(|_| self.light()).collect(),
            objects: (0..objects).map(|_| self.object(materials)).collect(),
        }
    }

    fn light(&mut self) -> Light {
        Light {
            position: self.bytes.point(self.reach),
            diffuse: self.bytes.color(BRIGHTEST),
            specular: self.bytes.color(BRIGHTEST),
        }
    }

    fn material(&mut self) -> Material {
        let bytes = &mut self.bytes;
        let mut coefficient = || match bytes.choice(2) {
            0 => bytes.color(Real::ONE),
            _ => Color::gray(Real::ZERO),
        };
        let [ka, kd, ks, kr, kt] = [0; 5].map(|_| coefficient());
        // Read only where it counts, so it may be anything elsewhere.
        let mut read_with = |color, [least, most]: [Real; 2]| match color == Color::gray(Real::ZERO)
        {
            true => bytes.number(Real::MIN, Real::MAX),
            false => bytes.number(least, most),
        };
        let shininess = read_with(ks, [Real::ONE, Real::lit("4096")]);
        let ior = read_with(kt, [Real::ONE, Real::lit("4")]);
        Material {
            ka,
            kd,
            ks,
            shininess,
            kr,
            kt,
            ior,
            le: bytes.color(BRIGHTEST),
            shading: [
                None,
                Some(SpecularModel::Phong),
                Some(SpecularModel::BlinnPhong),
            ][usize::from(bytes.choice(3))],
        }
    }

    fn size(&mut self) -> Real {
        self.bytes.number(self.smallest, self.reach)
    }

    /// Both ends of an extent.
    fn interval(&mut self) -> [Real; 2] {
        let [a, b] = [0; 2].map(|_| self.bytes.signed(self.reach));
        [a.min(b), a.max(b)]
    }

    fn perhaps(&mut self) -> Option<[Real; 2]> {
        (self.bytes.choice(2) == 0).then(|| self.interval())
    }

    fn object(&mut self, materials: u8) -> Object {
        Object {
            shape: self.shape(),
            texture: self.texture(materials),
        }
    }

    fn texture(&mut self, materials: u8) -> Texture {
        let [first, second] = [0; 2].map(|_| MaterialId(self.bytes.choice(materials).into()));
        if self.bytes.choice(3) != 0 {
            return Texture::Uniform(first);
        }
        let pairs = [[Axis::X, Axis::Y], [Axis::Z, Axis::Y], [Axis::Z, Axis::X]];
        Texture::Checker {
            size: self.size(),
            axes: pairs[usize::from(self.bytes.choice(3))],
            materials: [first, second],
        }
    }

    fn shape(&mut self) -> Shape {
        let center = self.bytes.point(self.reach);
        let (origin, radius) = (center, self.size());
        match self.bytes.choice(7) {
            0 => Shape::Sphere { center, radius },
            1 => {
                let longest = radius.saturating_mul(Real::lit("256")).min(self.reach);
                let mut radii = Vec3::new(radius, radius, radius);
                radii.x = self.bytes.number(radius, longest);
                radii.y = self.bytes.number(radius, longest);
                Shape::Ellipsoid { center, radii }
            }
            2 => Shape::Cylinder {
                origin,
                radius,
                y: self.perhaps(),
            },
            3 => {
                let [least, most] = [radius >> 10_u32, radius.saturating_mul(Real::lit("1024"))];
                let height = self.bytes.number(least, most);
                let up = self.bytes.choice(2) == 0;
                Shape::Cone {
                    origin,
                    radius,
                    height: if up { height } else { -height },
                    y: self.perhaps(),
                }
            }
            4 => Shape::Paraboloid {
                origin,
                y: self.interval(),
            },
            5 => Shape::Plane {
                normal: self.bytes.point(Real::lit("16777216")),
                point: center,
                bounds: ClipBox {
                    x: self.perhaps(),
                    y: self.perhaps(),
                    z: self.perhaps(),
                },
            },
            _ => Shape::Sphereflake {
                center,
                radius,
                depth: self.bytes.choice(9),
                ratio: self.bytes.number(Real::lit("0.1"), Real::lit("0.5")),
                frame: self.frame(),
            },
        }
    }

    /// Upright, or turned to another axis.
    fn frame(&mut self) -> [Vec3<Real>; 3] {
        let [u, v, w] = Shape::FLAKE_FRAME;
        [[u, v, w], [v, w, u], [w, u, v], [-u, -v, w]][usize::from(self.bytes.choice(4))]
    }
}

fn place(shape: &Shape) -> Vec3<Real> {
    match *shape {
        Shape::Sphere { center, .. }
        | Shape::Ellipsoid { center, .. }
        | Shape::Sphereflake { center, .. } => center,
        Shape::Cylinder { origin, .. }
        | Shape::Cone { origin, .. }
        | Shape::Paraboloid { origin, .. } => origin,
        Shape::Plane { point, .. } => point,
        _ => Vec3::default(),
    }
}
