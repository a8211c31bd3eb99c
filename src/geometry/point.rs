//! Points of a prepared scene, in the near and the extended range.
//!
//! The bounded geometry of a prepared scene lies within ±1 of the origin. A point is in the
//! *near range* if each coordinate is within ±3.5 ([`NEAR`]); its coordinates are then exact
//! [`Length`] values. Planes and unbounded quadrics also have points farther away, in the
//! *extended range*. Their coordinates are in units of `2^(shift - 28)`, so that the largest
//! coordinate still uses all of its bits. A ray direction has an error of 2^-30 anyway, so the
//! coarser unit loses no precision.

use crate::math::{Length, Vec3};

/// Largest coordinate of a point in the near range: 3.5, as the raw bits of a [`Length`].
///
/// The distance from a point in the near range to the bounded geometry is less than
/// `sqrt(3) * (3.5 + 1) < 8`, which fits a [`Length`].
pub(crate) const NEAR: i32 = 7 << 27;

/// Exponent of the largest hit distance. Hits at a distance of `2^(32 + HORIZON)` units of
/// 2^-28 or more are dropped. That limit is 2^26 times the size of the scene. No display has
/// pixels small enough to separate hits at this distance from the horizon.
///
/// The longest path in a ray tree has 33 such hits and stays below 2^60 units, so the shift of
/// a point stays below 32.
pub(crate) const HORIZON: i32 = 22;

/// A point at `coordinates * 2^shift`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Point {
    pub(crate) coordinates: Vec3<Length>,
    /// Zero for points in the near range (each coordinate within ±3.5).
    pub(crate) shift: u8,
}

impl Point {
    pub(crate) const fn near(coordinates: Vec3<Length>) -> Self {
        Self {
            coordinates,
            shift: 0,
        }
    }

    pub(crate) fn is_near(self) -> bool {
        self.shift == 0
    }

    /// Returns the point at the given coordinates, which are in units of `2^(shift - 28)`. The
    /// result has the smallest shift that its coordinates allow.
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

    /// Returns the vector from this point to `near`, a point in the near range (each coordinate
    /// within ±3.5). The vector is in units of `2^(shift - 28)`, where `shift` is the shift of
    /// this point. Its length is below 8 if its coordinates are read as [`Length`] values.
    pub(crate) fn to(self, near: Vec3<Length>) -> Vec3<Length> {
        near.zip(self.coordinates, |n, c| (n >> u32::from(self.shift)) - c)
    }
}

/// Returns true if all coordinates are in the near range, within ±3.5 ([`NEAR`]).
pub(crate) fn are_near(coordinates: Vec3<Length>) -> bool {
    coordinates.all(|c| c.to_bits().wrapping_add(NEAR) as u32 <= 2 * NEAR as u32)
}

/// Returns the largest magnitude of the three coordinates.
fn max_abs(c: Vec3<i64>) -> i64 {
    c.x.abs().max(c.y.abs()).max(c.z.abs())
}
