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

mod fields;
mod validate;

use core::mem::size_of;

pub use crate::math::Crc32;
use crate::prepare::{Light, Material, Object, PreparedScene, SceneSink, Settings};
pub use crate::scene::DecodeError;
use crate::scene::{SceneCounts, SceneItem};

use crate::archive::{Archive, Counter, Fields, Reader, Writer};

const MAGIC: [u8; 4] = *b"WHTD";
const VERSION: u8 = 3;
const CHECKSUM: usize = size_of::<u32>();

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

impl SceneCounts {
    /// Reads the numbers of items from the header of a compiled scene: the capacity of the
    /// smallest [`SceneBuffer`](crate::SceneBuffer) that decodes it.
    ///
    /// All are 0 if the bytes are too short for a header. Nothing else is validated here.
    ///
    /// ```
    /// use whitted::scene::SceneCounts;
    ///
    /// static SCENE: &[u8] = b"WHTD\x03\x05\0\x01\0\x03\0"; // include_bytes!("scene.bin")
    /// const COUNTS: SceneCounts = SceneCounts::of_compiled(SCENE);
    /// let buffer = <whitted::scene_buffer!(COUNTS)>::new();
    /// # let _ = buffer;
    /// assert_eq!((COUNTS.objects, COUNTS.lights, COUNTS.materials), (5, 1, 3));
    /// ```
    pub const fn of_compiled(compiled: &[u8]) -> Self {
        match compiled {
            [_, _, _, _, _, o0, o1, l0, l1, m0, m1, ..] => Self::EMPTY
                .objects(u16::from_le_bytes([*o0, *o1]) as usize)
                .lights(u16::from_le_bytes([*l0, *l1]) as usize)
                .materials(u16::from_le_bytes([*m0, *m1]) as usize),
            _ => Self::EMPTY,
        }
    }

    /// The capacity of the smallest buffer that decodes any of several compiled scenes.
    pub const fn of_all(scenes: &[&[u8]]) -> Self {
        let mut counts = Self::EMPTY;
        let mut rest = scenes;
        while let [scene, others @ ..] = rest {
            counts = counts.max(Self::of_compiled(scene));
            rest = others;
        }
        counts
    }
}

fn checksum_of(bytes: &[u8]) -> u32 {
    let mut crc = Crc32::new();
    crc.update(bytes);
    crc.finish()
}

/// Not inlined, as whoever decodes then draws, and its variables would take stack
/// all the while.
#[inline(never)]
pub(crate) fn decode(bytes: &[u8], room: &mut impl SceneSink) -> Result<Settings, DecodeError> {
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
        return Err(DecodeError::Version {
            found: header.version,
            expected: VERSION,
        });
    }
    if checksum_of(body) != u32::from_le_bytes(*checksum) {
        return Err(DecodeError::Checksum);
    }
    let mut settings = Settings::blank();
    settings.visit(&mut reader);
    check(settings.is_valid(), SceneItem::Scene)?;
    for index in 0..header.lights {
        let mut light = Light::default();
        light.visit(&mut reader);
        check(light.is_valid(), SceneItem::Light(index))?;
        room.push_light(light)?;
    }
    for index in 0..header.materials {
        let mut material = Material::default();
        material.visit(&mut reader);
        check(material.is_valid(), SceneItem::Material(index))?;
        room.push_material(material)?;
    }
    for index in 0..header.objects {
        let mut object = Object::NONE;
        object.visit(&mut reader);
        check(object.is_valid(header.materials), SceneItem::Object(index))?;
        room.push_object(object)?;
    }
    if reader.short || !reader.bytes.is_empty() {
        return Err(DecodeError::Length);
    }
    Ok(settings)
}

/// A right checksum over wrong values is no accident of transport; tracing
/// relies on every range all the same.
fn check(valid: bool, item: SceneItem) -> Result<(), DecodeError> {
    if valid {
        Ok(())
    } else {
        Err(DecodeError::Invalid(item))
    }
}
