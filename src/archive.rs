//! Where the fields of an item go to or come from: one list serves both ways.
//!
//! Nothing is inlined: there are many fields, and they are read once.

use fixed::traits::Fixed;

use crate::math::{Color, Vec3};

/// Where fields go to or come from.
pub(crate) trait Archive {
    fn bytes<const N: usize>(&mut self, bytes: &mut [u8; N]);

    /// Notes that a field needs a Cargo feature that is off.
    fn miss(&mut self, feature: &'static str) {
        let _ = feature;
    }
}

/// Counts bytes.
pub(crate) struct Counter(pub(super) usize);

impl Archive for Counter {
    fn bytes<const N: usize>(&mut self, _: &mut [u8; N]) {
        self.0 += N;
    }
}

/// Writes until there is no more room.
pub(crate) struct Writer<'a> {
    pub(crate) out: &'a mut [u8],
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

/// Reads; zeros past the end, which is remembered.
pub(crate) struct Reader<'a> {
    pub(crate) bytes: &'a [u8],
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

/// An item that is a list of fields.
pub(crate) trait Fields {
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

/// A number of the `fixed` crate by its bits.
#[inline(never)]
pub(crate) fn fixed<F, const N: usize>(value: &mut F, archive: &mut impl Archive)
where
    F: Fixed<Bytes = [u8; N]>,
{
    let mut bytes = value.to_le_bytes();
    archive.bytes(&mut bytes);
    *value = F::from_le_bytes(bytes);
}

#[inline(never)]
pub(crate) fn vector<F, const N: usize>(v: &mut Vec3<F>, archive: &mut impl Archive)
where
    F: Fixed<Bytes = [u8; N]>,
{
    fixed(&mut v.x, archive);
    fixed(&mut v.y, archive);
    fixed(&mut v.z, archive);
}

#[inline(never)]
pub(crate) fn color<F, const N: usize>(c: &mut Color<F>, archive: &mut impl Archive)
where
    F: Fixed<Bytes = [u8; N]>,
{
    fixed(&mut c.r, archive);
    fixed(&mut c.g, archive);
    fixed(&mut c.b, archive);
}
