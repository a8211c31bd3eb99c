//! Implementation in plain Rust, for all targets except Armv6-M.

#[inline(always)]
pub(crate) fn signed(a: i32, b: i32) -> i64 {
    i64::from(a) * i64::from(b)
}

#[inline(always)]
pub(crate) fn unsigned(a: u32, b: u32) -> u64 {
    u64::from(a) * u64::from(b)
}

#[inline(always)]
pub(crate) fn mixed(a: i32, b: u32) -> i64 {
    i64::from(a) * i64::from(b)
}

#[inline(always)]
pub(crate) fn square(a: i32) -> i64 {
    i64::from(a) * i64::from(a)
}

#[inline(always)]
pub(crate) fn upper(a: i32, b: i32) -> i32 {
    crate::rounded::<31>(signed(a, b))
}

#[inline(always)]
pub(crate) fn scaled<const SHIFT: u32>(v: [i32; 3], by: i32) -> [i32; 3] {
    v.map(|c| crate::rounded::<SHIFT>(signed(c, by)))
}

#[inline(always)]
pub(crate) fn reduced(v: [i32; 3], by: u32) -> [i32; 3] {
    // Because `by` is at least 2^31, `by - 2^32` fits in an i32. The code multiplies each
    // component `c` by `by - 2^32` and divides by 2^32. It then adds `c`, because the
    // factor was too small by 2^32.
    v.map(|c| c.wrapping_add(((signed(c, by as i32) + (1 << 31)) >> 32) as i32))
}

#[inline(always)]
pub(crate) fn leading_zeros(x: u32) -> u32 {
    x.leading_zeros()
}

#[inline(always)]
pub(crate) fn middle(a: u32, b: u32) -> u32 {
    (unsigned(a, b) >> 16) as u32
}

#[inline(always)]
pub(crate) fn by_16_bits(a: u32, b: i32) -> i32 {
    (signed((a << 1) as i32, b) >> 32) as i32
}

#[inline(always)]
pub(crate) fn by_17_bits(a: u32, b: u32) -> u32 {
    (unsigned(a << 15, b) >> 32) as u32
}

#[inline(always)]
pub(crate) fn square_of_21_bits(a: u32) -> u32 {
    let a = a << 11;
    (unsigned(a, a) >> 32) as u32
}

#[cfg(not(armv7m))]
#[inline(always)]
pub(crate) fn rounded<const SHIFT: u32>(x: i64) -> i32 {
    (x.wrapping_add(1 << (SHIFT - 1)) >> SHIFT) as i32
}
