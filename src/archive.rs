//! Serialization of the fields of an item.
//!
//! An item lists its fields once, in [`Fields::visit`]. The list serves to count, write and
//! read them, depending on the [`Archive`]. Numbers are stored as little-endian bits.
//!
//! Functions are `#[inline(never)]` to save flash: an item has many fields, and each is read
//! once.

use fixed::traits::Fixed;

use crate::math::{Color, Vec3};

/// Destination or source of bytes.
pub(crate) trait Archive {
    /// Writes `bytes`, or replaces them by bytes that were read.
    fn bytes<const N: usize>(&mut self, bytes: &mut [u8; N]);

    /// Notes that a field needs a Cargo feature that is off.
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
    /// Bytes written, including those dropped because `out` was full.
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

/// An archive that reads from a slice, and reads zeros past its end.
pub(crate) struct Reader<'a> {
    pub(crate) bytes: &'a [u8],
    /// True if a read went past the end.
    pub(crate) short: bool,
    /// Cargo feature that a field needs and that is off.
    pub(crate) missing: Option<&'static str>,
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

/// An item that consists of fields.
pub(crate) trait Fields {
    /// Writes each field to `archive`, or replaces each field by the value read from it.
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

/// Visits a fixed-point number.
#[inline(never)]
pub(crate) fn fixed<F, const N: usize>(value: &mut F, archive: &mut impl Archive)
where
    F: Fixed<Bytes = [u8; N]>,
{
    let mut bytes = value.to_le_bytes();
    archive.bytes(&mut bytes);
    *value = F::from_le_bytes(bytes);
}

/// Visits the components of a vector: x, y, z.
#[inline(never)]
pub(crate) fn vector<F, const N: usize>(v: &mut Vec3<F>, archive: &mut impl Archive)
where
    F: Fixed<Bytes = [u8; N]>,
{
    fixed(&mut v.x, archive);
    fixed(&mut v.y, archive);
    fixed(&mut v.z, archive);
}

/// Visits the channels of a color: red, green, blue.
#[inline(never)]
pub(crate) fn color<F, const N: usize>(c: &mut Color<F>, archive: &mut impl Archive)
where
    F: Fixed<Bytes = [u8; N]>,
{
    fixed(&mut c.r, archive);
    fixed(&mut c.g, archive);
    fixed(&mut c.b, archive);
}
