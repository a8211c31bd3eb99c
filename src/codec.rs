//! Compiled scenes. A compiled scene is a prepared scene as bytes, in a compact format with a
//! version and a checksum.
//!
//! ```text
//! "WHTD"  version: u8  objects, lights, materials: u16
//! settings, lights, materials, objects
//! b'A'  duration, shapes and tracks of the animation, if there is one
//! CRC-32 of everything before it
//! ```
//!
//! All numbers are little-endian integers, already scaled to the prepared scene. Values that
//! can be derived, such as a squared radius or a reciprocal, are not stored. Each kind of item
//! lists its fields once. The encoder and the decoder use the same list; see `archive::Fields`.

pub use crate::math::Crc32;
pub use crate::scene::DecodeError;

use crate::archive::{Archive, Counter, Fields, Reader, Writer};
use crate::prepare::{Light, Material, Object, PreparedScene, SceneSink, Settings};
use crate::scene::{SceneCounts, SceneItem};

const MAGIC: [u8; 4] = *b"WHTD";
const VERSION: u8 = 4;
const CHECKSUM: usize = size_of::<u32>();
/// Byte in front of an animation.
const ANIMATION: u8 = b'A';

/// The part of a compiled scene that follows its objects.
pub(crate) trait Section {
    /// Writes the bytes of the section.
    fn write(&self, archive: &mut impl Archive);
}

/// The lists and settings that a compiled scene stores.
#[derive(Clone, Copy)]
pub(crate) struct Content<'a> {
    pub(crate) settings: &'a Settings,
    pub(crate) lights: &'a [Light],
    pub(crate) materials: &'a [Material],
    pub(crate) objects: &'a [Object],
}

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

impl SceneCounts {
    /// Reads the header of a compiled scene and returns its numbers of objects, lights and
    /// materials. A [`SceneBuffer`](crate::SceneBuffer) of this capacity is the smallest that
    /// can decode the scene.
    ///
    /// All numbers are 0 if the bytes are too short for a header. This function checks nothing
    /// else.
    ///
    /// ```
    /// use whitted::scene::SceneCounts;
    ///
    /// static SCENE: &[u8] = b"WHTD\x04\x05\0\x01\0\x03\0"; // include_bytes!("scene.bin")
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

    /// Returns the capacity of the smallest buffer that can decode any one of several compiled
    /// scenes.
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

impl PreparedScene<'_> {
    /// Returns the number of bytes that [`encode`](Self::encode) writes for this scene.
    pub fn encoded_len(&self) -> usize {
        encoded_len(self.content(), None::<&NoSection>)
    }

    /// Writes the scene as bytes that [`SceneBuffer::decode`](crate::SceneBuffer::decode) can
    /// read. Returns the number of bytes, or `None` if `out` is too short.
    ///
    /// All numbers are little-endian integers, already scaled to the prepared scene. The bytes
    /// begin with a magic number and a version, and end with a CRC-32.
    pub fn encode(&self, out: &mut [u8]) -> Option<usize> {
        encode(self.content(), None::<&NoSection>, out)
    }

    fn content(&self) -> Content<'_> {
        Content {
            settings: &self.settings,
            lights: self.lights,
            materials: self.materials,
            objects: self.objects,
        }
    }
}

/// Stands for the missing section of a scene without animation.
enum NoSection {}

impl Section for NoSection {
    fn write(&self, _: &mut impl Archive) {}
}

/// Returns the number of bytes that [`encode`] writes.
pub(crate) fn encoded_len(scene: Content<'_>, animation: Option<&impl Section>) -> usize {
    let mut counter = Counter(0);
    visit_all(scene, animation, &mut counter);
    counter.0 + CHECKSUM
}

/// Writes a compiled scene. Returns the number of bytes, or `None` if `out` is too short.
pub(crate) fn encode(
    scene: Content<'_>,
    animation: Option<&impl Section>,
    out: &mut [u8],
) -> Option<usize> {
    let length = encoded_len(scene, animation);
    let (body, checksum) = out.get_mut(..length)?.split_last_chunk_mut::<CHECKSUM>()?;
    let mut writer = Writer {
        out: body,
        written: 0,
    };
    visit_all(scene, animation, &mut writer);
    *checksum = checksum_of(body).to_le_bytes();
    Some(length)
}

fn visit_all(scene: Content<'_>, animation: Option<&impl Section>, archive: &mut impl Archive) {
    let mut header = Header {
        magic: MAGIC,
        version: VERSION,
        objects: scene.objects.len() as u16,
        lights: scene.lights.len() as u16,
        materials: scene.materials.len() as u16,
    };
    header.visit(archive);
    scene.settings.clone().visit(archive);
    visit_list(scene.lights, archive);
    visit_list(scene.materials, archive);
    visit_list(scene.objects, archive);
    if let Some(animation) = animation {
        let mut tag = ANIMATION;
        tag.visit(archive);
        animation.write(archive);
    }
}

fn visit_list<T: Fields + Clone>(list: &[T], archive: &mut impl Archive) {
    list.iter().for_each(|item| item.clone().visit(archive));
}

fn checksum_of(bytes: &[u8]) -> u32 {
    let mut crc = Crc32::new();
    crc.update(bytes);
    crc.finish()
}

/// Decodes a compiled scene into `sink`. Returns its settings, and the bytes of its animation, which
/// are not checked. There are none if the scene has no animation.
///
/// This function is not inlined. Otherwise its local variables would stay on the stack while
/// the caller draws.
#[inline(never)]
pub(crate) fn decode<'b>(
    bytes: &'b [u8],
    sink: &mut impl SceneSink,
) -> Result<(Settings, Option<&'b [u8]>), DecodeError> {
    sink.clear();
    let (header, mut reader) = open(bytes)?;
    let mut settings = Settings::empty();
    settings.visit(&mut reader);
    check(settings.is_valid(), SceneItem::Scene)?;
    for index in 0..header.lights {
        let mut light = Light::default();
        light.visit(&mut reader);
        check(light.is_valid(), SceneItem::Light(index))?;
        sink.push_light(light)?;
    }
    for index in 0..header.materials {
        let mut material = Material::default();
        material.visit(&mut reader);
        check(material.is_valid(), SceneItem::Material(index))?;
        if !material.kt.is_black() && cfg!(not(feature = "glass")) {
            return Err(DecodeError::MissingFeature("glass"));
        }
        sink.push_material(material.with_derived_fields())?;
    }
    for index in 0..header.objects {
        let mut object = Object::NONE;
        object.visit(&mut reader);
        if let Some(feature) = reader.missing {
            return Err(DecodeError::MissingFeature(feature));
        }
        check(object.is_valid(header.materials), SceneItem::Object(index))?;
        sink.push_object(object)?;
    }
    match reader.bytes {
        _ if reader.short => Err(DecodeError::Length),
        [] => Ok((settings, None)),
        [ANIMATION, animation @ ..] => Ok((settings, Some(animation))),
        _ => Err(DecodeError::Length),
    }
}

/// Reads the header of a compiled scene and verifies its version and its checksum. Returns the
/// header, and a reader of the bytes between the header and the checksum.
fn open(bytes: &[u8]) -> Result<(Header, Reader<'_>), DecodeError> {
    if !bytes.starts_with(&MAGIC) {
        return Err(DecodeError::NotAScene);
    }
    let (body, checksum) = bytes
        .split_last_chunk::<CHECKSUM>()
        .ok_or(DecodeError::Length)?;
    let mut reader = Reader::new(body);
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
    Ok((header, reader))
}

/// Returns an error if an item has a value that is out of range for ray tracing. A valid
/// checksum does not exclude such values, because any program can write compiled scenes.
fn check(is_valid: bool, item: SceneItem) -> Result<(), DecodeError> {
    if is_valid {
        Ok(())
    } else {
        Err(DecodeError::Invalid(item))
    }
}
