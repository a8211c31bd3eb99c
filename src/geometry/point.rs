//! Points of a prepared scene, in the near and the extended range.
//!
//! The bounded geometry of a prepared scene lies within ±1 of the origin. A point within
//! ±[`NEAR`] is *near* and has exact [`Length`] coordinates. Only planes and unbounded
//! quadrics have points farther away: those are in the *extended range*, in steps of
//! `2^shift`, so that the largest coordinate still uses its bits. A ray direction is known to
//! 2^-30, so the coarser steps lose nothing.

use crate::math::{Length, Vec3};

/// Largest coordinate of a near point.
///
/// From a near point to the bounded geometry it is less than `sqrt(3) * (3.5 + 1) < 8`, which
/// a [`Length`] holds.
pub(crate) const NEAR: i32 = 7 << 27;

/// A hit is dropped from a distance of `2^(32 + HORIZON)` steps on: 2^26 times the size of the
/// scene, closer to the horizon than the pixels of any display resolve.
///
/// A path of 33 such hits, the longest in a ray tree, stays below 2^60 steps, so the shift of
/// a point stays below 32.
pub(crate) const HORIZON: i32 = 22;

/// The point `coordinates * 2^shift`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Point {
    pub(crate) coordinates: Vec3<Length>,
    /// Zero for near points.
    pub(crate) shift: u8,
}

impl Point {
    #[inline(always)]
    pub(crate) const fn near(coordinates: Vec3<Length>) -> Self {
        Self {
            coordinates,
            shift: 0,
        }
    }

    #[inline(always)]
    pub(crate) fn is_near(self) -> bool {
        self.shift == 0
    }

    /// Normalizes coordinates in steps of `2^shift` to the smallest shift that fits them.
    pub(crate) fn normalized(mut coordinates: Vec3<i64>, mut shift: u32) -> Self {
        loop {
            let largest = max_abs(coordinates);
            if largest >= 1 << 30 || shift == 0 && largest > i64::from(NEAR) {
                coordinates = coordinates.map(|c| c >> 1);
                shift += 1;
            } else if shift > 0 && largest < 1 << 28 {
                coordinates = coordinates.map(|c| c << 1);
                shift -= 1;
            } else {
                break;
            }
        }
        Self {
            coordinates: coordinates.map(|c| Length::from_bits(c as i32)),
            shift: shift as u8,
        }
    }

    /// Returns the vector from this point to a near point, in steps of this point's
    /// `2^shift`. Its length is below 8.
    #[inline(always)]
    pub(crate) fn to(self, near: Vec3<Length>) -> Vec3<Length> {
        near.zip(self.coordinates, |n, c| (n >> u32::from(self.shift)) - c)
    }
}

/// Returns true if all coordinates are within ±[`NEAR`].
#[inline(always)]
pub(crate) fn are_near(coordinates: Vec3<Length>) -> bool {
    coordinates.all(|c| c.to_bits().wrapping_add(NEAR) as u32 <= 2 * NEAR as u32)
}

/// Largest magnitude of the coordinates.
fn max_abs(c: Vec3<i64>) -> i64 {
    c.x.abs().max(c.y.abs()).max(c.z.abs())
}
