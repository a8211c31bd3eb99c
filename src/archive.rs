//! Serialization of the items of a scene, field by field.
//!
//! An item lists its fields once, in [`Fields::visit`]. The [`Archive`] that visits the fields
//! decides whether they are counted, written or read. Numbers are stored in little-endian byte
//! order.
//!
//! The functions of this file are `#[inline(never)]`, because inlining them for each of an
//! item's many fields would take more flash. Reading a field does not need to be fast.

use fixed::traits::Fixed;

use crate::math::{Color, Vec3};

/// A visitor that counts, writes or reads the bytes of a scene's fields.
pub(crate) trait Archive {
    /// Processes the next bytes of a scene. An encoder writes `bytes`, a decoder overwrites `bytes`
    /// with the stored bytes, and a counter only adds their number.
    fn bytes<const N: usize>(&mut self, bytes: &mut [u8; N]);

    /// Records that a field of the scene needs a Cargo feature that is off.
    fn miss(&mut self, feature: &'static str) {
        let _ = feature;
    }
}

/// An archive that counts bytes.
pub(crate) struct Counter(pub(crate) usize);

impl Archive for Counter {
    fn bytes<const N: usize>(&mut self, _: &mut [u8; N]) {
        self.0 += N;
    }
}

/// An archive that writes to a slice.
pub(crate) struct Writer<'a> {
    pub(crate) out: &'a mut [u8],
    /// Number of bytes written, including bytes that were dropped because `out` was full.
    pub(crate) written: usize,
}

impl Archive for Writer<'_> {
    fn bytes<const N: usize>(&mut self, bytes: &mut [u8; N]) {
        if let Some(room) = self.out.get_mut(self.written..self.written + N) {
            room.copy_from_slice(bytes);
        }
        self.written += N;
    }
}

/// An archive that reads from a slice. Reads past the end of the slice return zeros.
pub(crate) struct Reader<'a> {
    pub(crate) bytes: &'a [u8],
    /// True if a read went past the end of the slice.
    pub(crate) short: bool,
    /// Name of a Cargo feature that a field needs but that is off.
    pub(crate) missing: Option<&'static str>,
}

impl<'a> Reader<'a> {
    pub(crate) fn new(bytes: &'a [u8]) -> Self {
        Self {
            bytes,
            short: false,
            missing: None,
        }
    }
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

    fn miss(&mut self, feature: &'static str) {
        self.missing = Some(feature);
    }
}

/// An item of a scene that can be written and read field by field.
pub(crate) trait Fields {
    /// Passes each field to `archive`. The archive counts the field, writes it, or replaces its
    /// value.
    fn visit(&mut self, archive: &mut impl Archive);
}

macro_rules! integers {
    ($($integer:ty),*) => {$(
        impl Fields for $integer {
            #[inline(never)]
            fn visit(&mut self, archive: &mut impl Archive) {
                let mut bytes = self.to_le_bytes();
                archive.bytes(&mut bytes);
                *self = Self::from_le_bytes(bytes);
            }
        }
    )*};
}

integers!(u8, i8, u16, i32, u32, i64);

/// Passes a fixed-point number to an archive.
#[inline(never)]
pub(crate) fn fixed<F, const N: usize>(value: &mut F, archive: &mut impl Archive)
where
    F: Fixed<Bytes = [u8; N]>,
{
    let mut bytes = value.to_le_bytes();
    archive.bytes(&mut bytes);
    *value = F::from_le_bytes(bytes);
}

/// Passes the components of a vector to an archive: x, y, z.
#[inline(never)]
pub(crate) fn vector<F, const N: usize>(v: &mut Vec3<F>, archive: &mut impl Archive)
where
    F: Fixed<Bytes = [u8; N]>,
{
    fixed(&mut v.x, archive);
    fixed(&mut v.y, archive);
    fixed(&mut v.z, archive);
}

/// Passes the channels of a color to an archive: red, green, blue.
#[inline(never)]
pub(crate) fn color<F, const N: usize>(c: &mut Color<F>, archive: &mut impl Archive)
where
    F: Fixed<Bytes = [u8; N]>,
{
    fixed(&mut c.r, archive);
    fixed(&mut c.g, archive);
    fixed(&mut c.b, archive);
}
