//! The mapping from world units to the coordinates of a prepared scene.

use fixed::types::U0F32;

use super::extent::Extent;
use super::point::NEAR;
use crate::math::{Length, Real, Unit, Vec3, bits, shift_rounded};
use crate::scene::SceneProblem;

/// Number of bits of a plane's offset. Offsets are below 2^48 units of 2^-28, which is 2^20
/// times the size of the bounded geometry.
pub(crate) const OFFSET_BITS: i32 = 48;

/// Largest exponent of the scale. At this exponent, the raw bits of a distance are the same in
/// world units ([`Real`]) and in prepared units ([`Length`]).
pub(crate) const MAX_EXPONENT: i32 = 4;

/// The mapping from world units to prepared units, a translation and a scale:
/// `prepared = (world - center) * 2^exponent`.
///
/// Scaling by a power of two is exact. In prepared units, the coordinates of the bounded
/// geometry, the eye and the lights are within ±1.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Normalization {
    /// Center of the scene, as the raw bits of a [`Real`].
    pub(crate) center: Vec3<i64>,
    /// Exponent of the scale, from -32 to [`MAX_EXPONENT`].
    pub(crate) exponent: i32,
}

impl Normalization {
    /// Returns the mapping that brings an extent within ±1.
    pub(crate) fn fit(extent: &Extent) -> Self {
        let center = extent.center();
        let half = extent.high.zip(center, |high, center| high - center + 1);
        Self {
            center,
            exponent: (32 - bits(half.x.max(half.y).max(half.z))).min(MAX_EXPONENT),
        }
    }

    /// Returns this mapping with its exponent limited to at most `exponent`.
    pub(crate) fn with_exponent_at_most(self, exponent: i32) -> Self {
        Self {
            exponent: self.exponent.min(exponent),
            ..self
        }
    }

    /// Converts a distance from world units to prepared units, rounded. The argument is the raw
    /// bits of a [`Real`], and the result is the raw bits of a [`Length`].
    #[inline(never)]
    pub(crate) fn length(&self, bits: i64) -> i64 {
        shift_rounded(bits.into(), self.exponent - 4) as i64
    }

    /// Converts a size from world units to prepared units, rounded.
    pub(crate) fn size(&self, size: Real) -> Length {
        Length::from_bits(self.length(size.to_bits()) as i32)
    }

    /// Converts a size from world units to prepared units and returns half of it, rounded. The
    /// argument is the raw bits of a [`Real`].
    pub(crate) fn half_size(&self, bits: i64) -> Length {
        Length::from_bits(shift_rounded(bits.into(), self.exponent - 5) as i32)
    }

    /// Converts a size to prepared units, rounded. The result must be below 1.
    pub(crate) fn fraction(&self, size: Real) -> U0F32 {
        let bits = shift_rounded(size.to_bits().into(), self.exponent);
        U0F32::from_bits(bits.min(u32::MAX.into()) as u32)
    }

    /// Converts an area from world units to prepared units, rounded. The argument is the raw
    /// bits of a [`Real`], and the result is in Q56.
    pub(crate) fn area(&self, bits: i64) -> i64 {
        shift_rounded(bits.into(), 24 + 2 * self.exponent) as i64
    }

    /// Converts a point from world units to prepared units, rounded. The result must be within
    /// ±8.
    #[inline(never)]
    pub(crate) fn point(&self, point: Vec3<Real>) -> Vec3<Length> {
        point.zip(self.center, |p, c| {
            Length::from_bits(self.length(p.to_bits() - c) as i32)
        })
    }

    /// Returns true if rays may start at a point, that is, if its prepared coordinates are in
    /// the near range (within ±3.5). Everything that determined the scale is within ±1.
    pub(crate) fn is_near(&self, point: Vec3<Real>) -> bool {
        let way = point.zip(self.center, |p, c| self.length(p.to_bits() - c));
        way.all(|c| c.abs() <= i64::from(NEAR))
    }

    /// Returns true if rays may start at any point of a box.
    pub(crate) fn has_near(&self, extent: &Extent) -> bool {
        [extent.low, extent.high]
            .into_iter()
            .all(|corner| self.is_near(corner.map(Real::from_bits)))
    }

    /// Returns true if the prepared coordinates of a box are within ±1.
    pub(crate) fn contains(&self, extent: &Extent) -> bool {
        let one = i64::from(Length::ONE.to_bits());
        [extent.low, extent.high].into_iter().all(|corner| {
            let way = corner.zip(self.center, |p, c| self.length(p - c));
            way.all(|c| c.abs() <= one)
        })
    }

    /// Computes the offset `normal · point` of a plane in the prepared scene, as the raw bits
    /// of a [`Length`]. Returns `None` if the plane is too far away for any ray to reach.
    pub(crate) fn offset(&self, normal: Vec3<Unit>, point: Vec3<Real>) -> Option<i64> {
        let way = point.zip(self.center, |p, c| i128::from(p.to_bits() - c));
        let along = way.zip(normal, |w, n| w * i128::from(n.to_bits()));
        let offset = shift_rounded(along.x + along.y + along.z, self.exponent - 34);
        (offset.abs() < 1 << OFFSET_BITS).then_some(offset as i64)
    }

    /// Returns the problem to report for a plane whose offset is out of range.
    pub(crate) fn offset_problem(&self) -> SceneProblem {
        let most = Real::from_bits(1 << (OFFSET_BITS + 4 - self.exponent).clamp(0, 62));
        SceneProblem::OutOfRange { least: -most, most }
    }

    /// Returns the size in world units that becomes 2^-18 in the prepared scene, which is 2^10
    /// units of a [`Length`].
    pub(crate) fn smallest_size(&self) -> Real {
        Real::from_bits(1 << (14 - self.exponent).clamp(0, 62))
    }
}
