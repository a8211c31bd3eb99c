//! Prepared scenes as bytes: compact, versioned, checked.
//!
//! ```text
//! "WHTD"  version: u8  objects, lights, materials: u16
//! settings, lights, materials, objects
//! CRC-32 of all before
//! ```
//!
//! Integers are little-endian and already scaled. What follows from others (a
//! squared radius, a reciprocal) is not stored. One list of fields per item
//! serves both directions.

use core::mem::size_of;

use fixed::traits::Fixed;

use crate::num::{Factor, Length, Unit};
use crate::prepared::{
    Camera, Light, MAX_DEPTH, Material, OFFSET_BITS, Object, PreparedScene, Room, Settings,
};
use crate::shape::{Bounds, Plane, Shape, Sphere};
use crate::texture::{Checker, Texture};
use crate::{Axis, Color, Crc32, DecodeError, Item, Vec3};

const MAGIC: [u8; 4] = *b"WHTD";
const VERSION: u8 = 1;
const CHECKSUM: usize = size_of::<u32>();

/// Where fields go to or come from.
trait Archive {
    fn bytes<const N: usize>(&mut self, bytes: &mut [u8; N]);
}

/// Counts bytes.
struct Counter(usize);

impl Archive for Counter {
    fn bytes<const N: usize>(&mut self, _: &mut [u8; N]) {
        self.0 += N;
    }
}

/// Writes until there is no more room.
struct Writer<'a> {
    out: &'a mut [u8],
    written: usize,
}

impl Archive for Writer<'_> {
    fn bytes<const N: usize>(&mut self, bytes: &mut [u8; N]) {
        if let Some(room) = self.out.get_mut(self.written..self.written + N) {
            room.copy_from_slice(bytes);
        }
        self.written += N;
    }
}

/// Reads; zeros past the end, which is remembered.
struct Reader<'a> {
    bytes: &'a [u8],
    short: bool,
}

impl Archive for Reader<'_> {
    fn bytes<const N: usize>(&mut self, bytes: &mut [u8; N]) {
        if let Some((first, rest)) = self.bytes.split_first_chunk::<N>() {
            (*bytes, self.bytes) = (*first, rest);
        } else {
            self.short = true;
            *bytes = [0; N];
        }
    }
}

/// An item that is a list of fields.
trait Fields {
    fn visit(&mut self, archive: &mut impl Archive);
}

macro_rules! integers {
    ($($integer:ty),*) => {$(
        impl Fields for $integer {
            fn visit(&mut self, archive: &mut impl Archive) {
                let mut bytes = self.to_le_bytes();
                archive.bytes(&mut bytes);
                *self = Self::from_le_bytes(bytes);
            }
        }
    )*};
}

integers!(u8, i8, u16, u32, i64);

/// A number of the `fixed` crate by its bits.
fn fixed<F, const N: usize>(value: &mut F, archive: &mut impl Archive)
where
    F: Fixed<Bytes = [u8; N]>,
{
    let mut bytes = value.to_le_bytes();
    archive.bytes(&mut bytes);
    *value = F::from_le_bytes(bytes);
}

fn vector<F, const N: usize>(v: &mut Vec3<F>, archive: &mut impl Archive)
where
    F: Fixed<Bytes = [u8; N]>,
{
    fixed(&mut v.x, archive);
    fixed(&mut v.y, archive);
    fixed(&mut v.z, archive);
}

fn color<F, const N: usize>(c: &mut Color<F>, archive: &mut impl Archive)
where
    F: Fixed<Bytes = [u8; N]>,
{
    fixed(&mut c.r, archive);
    fixed(&mut c.g, archive);
    fixed(&mut c.b, archive);
}

impl Fields for Settings {
    fn visit(&mut self, archive: &mut impl Archive) {
        let Camera {
            eye,
            forward,
            right,
            up,
            tangent,
        } = &mut self.camera;
        vector(eye, archive);
        vector(forward, archive);
        vector(right, archive);
        vector(up, archive);
        tangent.visit(archive);
        color(&mut self.horizon, archive);
        color(&mut self.zenith, archive);
        self.exposure.visit(archive);
        self.max_depth.visit(archive);
        fixed(&mut self.min_weight, archive);
    }
}

impl Fields for Light {
    fn visit(&mut self, archive: &mut impl Archive) {
        vector(&mut self.position, archive);
        color(&mut self.diffuse, archive);
        color(&mut self.specular, archive);
    }
}

impl Fields for Material {
    fn visit(&mut self, archive: &mut impl Archive) {
        color(&mut self.glow, archive);
        color(&mut self.kd, archive);
        color(&mut self.ks, archive);
        color(&mut self.kr, archive);
        color(&mut self.kt, archive);
        self.shininess.visit(archive);
        fixed(&mut self.ior, archive);
        fixed(&mut self.inverse_ior, archive);
        let mut blinn = u8::from(self.blinn);
        blinn.visit(archive);
        self.blinn = blinn != 0;
    }
}

impl Fields for Object {
    fn visit(&mut self, archive: &mut impl Archive) {
        const SPHERE: u8 = 0;
        const PLANE: u8 = 1;
        const BOUNDED_PLANE: u8 = 2;
        let mut kind = match &self.shape {
            Shape::Sphere(_) => SPHERE,
            Shape::Plane(Plane { bounds: None, .. }) => PLANE,
            Shape::Plane(_) => BOUNDED_PLANE,
        };
        kind.visit(archive);
        self.shape = if kind == SPHERE {
            let Sphere {
                mut center,
                mut radius,
                ..
            } = match self.shape {
                Shape::Sphere(sphere) => sphere,
                Shape::Plane(_) => Sphere::default(),
            };
            vector(&mut center, archive);
            fixed(&mut radius, archive);
            Shape::Sphere(Sphere::new(center, radius))
        } else {
            let mut plane = match self.shape {
                Shape::Plane(plane) => plane,
                Shape::Sphere(_) => Plane::default(),
            };
            vector(&mut plane.normal, archive);
            plane.offset.visit(archive);
            plane.bounds = (kind == BOUNDED_PLANE).then(|| {
                let mut bounds = plane.bounds.unwrap_or(Bounds::ENDLESS);
                vector(&mut bounds.low, archive);
                vector(&mut bounds.high, archive);
                bounds
            });
            Shape::Plane(plane)
        };
        self.texture.visit(archive);
    }
}

impl Fields for Texture {
    fn visit(&mut self, archive: &mut impl Archive) {
        const UNIFORM: u8 = 0;
        const CHECKER: u8 = 1;
        let mut kind = match self {
            Self::Uniform(_) => UNIFORM,
            Self::Checker(_) => CHECKER,
        };
        kind.visit(archive);
        *self = if kind == UNIFORM {
            let mut material = match *self {
                Self::Uniform(material) => material,
                Self::Checker(_) => 0,
            };
            material.visit(archive);
            Self::Uniform(material)
        } else {
            let mut checker = match *self {
                Self::Checker(checker) => checker,
                Self::Uniform(_) => Checker::default(),
            };
            checker.mantissa.visit(archive);
            checker.exponent.visit(archive);
            checker
                .phase
                .iter_mut()
                .for_each(|phase| phase.visit(archive));
            for axis in &mut checker.axes {
                let mut index = *axis as u8;
                index.visit(archive);
                *axis = match index {
                    0 => Axis::X,
                    1 => Axis::Y,
                    _ => Axis::Z,
                };
            }
            checker
                .materials
                .iter_mut()
                .for_each(|material| material.visit(archive));
            Self::Checker(checker)
        };
    }
}

/// What is before the lists.
#[derive(Default)]
struct Header {
    magic: [u8; 4],
    version: u8,
    objects: u16,
    lights: u16,
    materials: u16,
}

impl Fields for Header {
    fn visit(&mut self, archive: &mut impl Archive) {
        archive.bytes(&mut self.magic);
        self.version.visit(archive);
        self.objects.visit(archive);
        self.lights.visit(archive);
        self.materials.visit(archive);
    }
}

fn visit_all(scene: &PreparedScene<'_>, archive: &mut impl Archive) {
    let mut header = Header {
        magic: MAGIC,
        version: VERSION,
        objects: scene.objects.len() as u16,
        lights: scene.lights.len() as u16,
        materials: scene.materials.len() as u16,
    };
    header.visit(archive);
    scene.settings.clone().visit(archive);
    scene
        .lights
        .iter()
        .for_each(|light| light.clone().visit(archive));
    scene
        .materials
        .iter()
        .for_each(|material| material.clone().visit(archive));
    scene
        .objects
        .iter()
        .for_each(|object| object.clone().visit(archive));
}

pub(crate) fn encoded_len(scene: &PreparedScene<'_>) -> usize {
    let mut counter = Counter(0);
    visit_all(scene, &mut counter);
    counter.0 + CHECKSUM
}

pub(crate) fn encode(scene: &PreparedScene<'_>, out: &mut [u8]) -> Option<usize> {
    let length = encoded_len(scene);
    let (body, checksum) = out.get_mut(..length)?.split_last_chunk_mut::<CHECKSUM>()?;
    visit_all(
        scene,
        &mut Writer {
            out: body,
            written: 0,
        },
    );
    *checksum = checksum_of(body).to_le_bytes();
    Some(length)
}

fn checksum_of(bytes: &[u8]) -> u32 {
    let mut crc = Crc32::new();
    crc.update(bytes);
    crc.finish()
}

pub(crate) fn decode(bytes: &[u8], room: &mut impl Room) -> Result<Settings, DecodeError> {
    room.clear();
    if !bytes.starts_with(&MAGIC) {
        return Err(DecodeError::NotAScene);
    }
    let (body, checksum) = bytes
        .split_last_chunk::<CHECKSUM>()
        .ok_or(DecodeError::Length)?;
    let mut reader = Reader {
        bytes: body,
        short: false,
    };
    let mut header = Header::default();
    header.visit(&mut reader);
    if reader.short {
        return Err(DecodeError::Length);
    }
    if header.version != VERSION {
        return Err(DecodeError::Version(header.version));
    }
    if checksum_of(body) != u32::from_le_bytes(*checksum) {
        return Err(DecodeError::Checksum);
    }
    let mut settings = Settings::default();
    settings.visit(&mut reader);
    check(settings.is_valid(), Item::Scene)?;
    for index in 0..header.lights {
        let mut light = Light::default();
        light.visit(&mut reader);
        check(light.is_valid(), Item::Light(index))?;
        room.push_light(light)?;
    }
    for index in 0..header.materials {
        let mut material = Material::default();
        material.visit(&mut reader);
        check(material.is_valid(), Item::Material(index))?;
        room.push_material(material)?;
    }
    for index in 0..header.objects {
        let mut object = Object::default();
        object.visit(&mut reader);
        check(object.is_valid(header.materials), Item::Object(index))?;
        room.push_object(object)?;
    }
    if reader.short || !reader.bytes.is_empty() {
        return Err(DecodeError::Length);
    }
    Ok(settings)
}

/// A right checksum over wrong values is no accident of transport; tracing
/// relies on every range all the same.
fn check(valid: bool, item: Item) -> Result<(), DecodeError> {
    if valid {
        Ok(())
    } else {
        Err(DecodeError::Invalid(item))
    }
}

fn is_within_one(point: Vec3<Length>) -> bool {
    point.all(|c| c.abs() <= Length::ONE)
}

fn is_unit(v: Vec3<Unit>) -> bool {
    // Within 2^-20 of 1.
    let excess = v.dot(v).to_bits() - (1 << 60);
    v.all(|c| c.abs() <= Unit::ONE) && excess.abs() < 1 << 40
}

fn are_factors<const N: usize>(colors: [Color<Factor>; N]) -> bool {
    colors
        .into_iter()
        .all(|color| color.all(|c| c <= Factor::ONE))
}

impl Settings {
    fn is_valid(&self) -> bool {
        let Camera {
            eye,
            forward,
            right,
            up,
            tangent,
        } = self.camera;
        is_within_one(eye)
            && [forward, right, up].into_iter().all(is_unit)
            && (1..12 << 28).contains(&tangent)
            && are_factors([self.horizon, self.zenith])
            && self.exposure < 16
            && self.max_depth <= MAX_DEPTH
            && self.min_weight <= Factor::ONE
    }
}

impl Light {
    fn is_valid(&self) -> bool {
        is_within_one(self.position) && are_factors([self.diffuse, self.specular])
    }
}

impl Material {
    fn is_valid(&self) -> bool {
        are_factors([self.kd, self.ks, self.kr, self.kt])
            && (1 << 16..=4096 << 16).contains(&self.shininess)
            && (Length::ONE..=const { Length::lit("4") }).contains(&self.ior)
            && (Length::ONE / 4..=Length::ONE).contains(&self.inverse_ior)
    }
}

impl Object {
    fn is_valid(&self, materials: u16) -> bool {
        let shape = match &self.shape {
            Shape::Sphere(sphere) => {
                is_within_one(sphere.center)
                    && (Length::DELTA..=Length::ONE).contains(&sphere.radius)
            }
            Shape::Plane(plane) => {
                is_unit(plane.normal) && plane.offset.unsigned_abs() < 1 << OFFSET_BITS
            }
        };
        let texture = match &self.texture {
            Texture::Uniform(material) => *material < materials,
            Texture::Checker(checker) => {
                checker.mantissa >> 31 == 1
                    && checker
                        .materials
                        .iter()
                        .all(|material| *material < materials)
            }
        };
        shape && texture
    }
}
