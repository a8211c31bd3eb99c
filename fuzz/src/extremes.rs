use whitted::scene::{Axis, ClipBox, SpecularModel};
use whitted::{
    Background, Camera, Color, Light, Material, MaterialId, Object, Real, Scene, SceneBuffer,
    Shape, Texture, Vec3, real,
};

use super::bytes::Bytes;
use super::picture::draw_as_compiled;

type Buffer = SceneBuffer<6, 3, 3>;

/// Upper limit of light and background colors.
const MAX_RADIANCE: Real = real!(256);

/// Checks scenes whose numbers are often at the ends of their valid ranges.
///
/// The scene must be rejected, or give the same pixels before and after compilation.
/// Returns true if the scene is valid.
pub fn extremes(input: &[u8]) -> bool {
    let mut generator = SceneGenerator::new(Bytes(input));
    let lists = generator.lists();
    let scene = generator.scene(&lists.objects);
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

/// Generates scenes from fuzz input.
struct SceneGenerator<'a> {
    bytes: Bytes<'a>,
    /// Largest absolute coordinate.
    max_coordinate: Real,
    /// Smallest size of an object that is likely to be valid.
    min_size: Real,
}

struct Lists {
    lights: Vec<Light>,
    materials: Vec<Material>,
    objects: Vec<Object>,
}

impl<'a> SceneGenerator<'a> {
    fn new(mut bytes: Bytes<'a>) -> Self {
        let min = real!(0.000001);
        let max = real!(16777216);
        let max_coordinate = match bytes.choice(4) {
            0 => max,
            1 => min * 64,
            _ => bytes.number(min, max),
        };
        let min_size = (max_coordinate >> 16_u32).max(min);
        Self {
            bytes,
            max_coordinate,
            min_size,
        }
    }

    fn camera(&mut self, objects: &[Object]) -> Camera {
        let Self {
            bytes,
            max_coordinate,
            ..
        } = self;
        // Three of four cameras look at the first object.
        let look_at = match objects {
            [first, ..] if bytes.choice(4) != 0 => position(&first.shape),
            _ => bytes.point(*max_coordinate),
        };
        Camera {
            eye: bytes.point(*max_coordinate),
            look_at,
            up: bytes.point(real!(16777216)),
            fovy_deg: bytes.number(real!(1), real!(170)),
        }
    }

    fn scene(&mut self, objects: &[Object]) -> Scene<'static> {
        let camera = self.camera(objects);
        let bytes = &mut self.bytes;
        let background = match bytes.choice(2) {
            0 => Background::Solid(bytes.color(MAX_RADIANCE)),
            _ => Background::Gradient {
                horizon: bytes.color(MAX_RADIANCE),
                zenith: bytes.color(MAX_RADIANCE),
            },
        };
        Scene {
            ambient: bytes.color(MAX_RADIANCE),
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
            position: self.bytes.point(self.max_coordinate),
            diffuse: self.bytes.color(MAX_RADIANCE),
            specular: self.bytes.color(MAX_RADIANCE),
        }
    }

    fn material(&mut self) -> Material {
        let bytes = &mut self.bytes;
        let mut coefficient = || match bytes.choice(2) {
            0 => bytes.color(Real::ONE),
            _ => Color::gray(Real::ZERO),
        };
        let [ka, kd, ks, kr, kt] = [0; 5].map(|_| coefficient());
        // The library ignores shininess and index of refraction if their coefficient is
        // black, so any value is valid then.
        let mut parameter = |color, [min, max]: [Real; 2]| match color == Color::gray(Real::ZERO) {
            true => bytes.number(Real::MIN, Real::MAX),
            false => bytes.number(min, max),
        };
        let shininess = parameter(ks, [Real::ONE, real!(4096)]);
        let ior = parameter(kt, [Real::ONE, real!(4)]);
        Material {
            ka,
            kd,
            ks,
            shininess,
            kr,
            kt,
            ior,
            le: bytes.color(MAX_RADIANCE),
            shading: [
                None,
                Some(SpecularModel::Phong),
                Some(SpecularModel::BlinnPhong),
            ][usize::from(bytes.choice(3))],
        }
    }

    fn size(&mut self) -> Real {
        self.bytes.number(self.min_size, self.max_coordinate)
    }

    /// Returns an interval of coordinates.
    fn interval(&mut self) -> [Real; 2] {
        let [a, b] = [0; 2].map(|_| self.bytes.signed(self.max_coordinate));
        [a.min(b), a.max(b)]
    }

    /// Returns an interval or `None`, with equal probability.
    fn optional_interval(&mut self) -> Option<[Real; 2]> {
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
        let center = self.bytes.point(self.max_coordinate);
        let (origin, radius) = (center, self.size());
        match self.bytes.choice(7) {
            0 => Shape::Sphere { center, radius },
            1 => {
                let longest = radius.saturating_mul(real!(256)).min(self.max_coordinate);
                let mut radii = Vec3::new(radius, radius, radius);
                radii.x = self.bytes.number(radius, longest);
                radii.y = self.bytes.number(radius, longest);
                Shape::Ellipsoid { center, radii }
            }
            2 => Shape::Cylinder {
                origin,
                radius,
                y: self.optional_interval(),
            },
            3 => {
                let [min, max] = [radius >> 10_u32, radius.saturating_mul(real!(1024))];
                let height = self.bytes.number(min, max);
                let up = self.bytes.choice(2) == 0;
                Shape::Cone {
                    origin,
                    radius,
                    height: if up { height } else { -height },
                    y: self.optional_interval(),
                }
            }
            4 => Shape::Paraboloid {
                origin,
                y: self.interval(),
            },
            5 => Shape::Plane {
                normal: self.bytes.point(real!(16777216)),
                point: center,
                bounds: ClipBox {
                    x: self.optional_interval(),
                    y: self.optional_interval(),
                    z: self.optional_interval(),
                },
            },
            _ => Shape::Sphereflake {
                center,
                radius,
                depth: self.bytes.choice(9),
                ratio: self.bytes.number(real!(0.1), real!(0.5)),
                frame: self.frame(),
            },
        }
    }

    /// Returns the default frame of a sphereflake or a rotated one.
    fn frame(&mut self) -> [Vec3<Real>; 3] {
        let [u, v, w] = Shape::FLAKE_FRAME;
        [[u, v, w], [v, w, u], [w, u, v], [-u, -v, w]][usize::from(self.bytes.choice(4))]
    }
}

/// Returns the reference point of a shape.
fn position(shape: &Shape) -> Vec3<Real> {
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
