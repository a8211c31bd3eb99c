use super::point::{NEAR, Point};
use crate::math::{Length, Unit, Vec3};

/// An axis-aligned box that a plane is clipped to.
///
/// A side without a bound is [`Length::MIN`] or [`Length::MAX`].
#[derive(Clone, Copy, Debug)]
pub(crate) struct ClipBox {
    pub(crate) low: Vec3<Length>,
    pub(crate) high: Vec3<Length>,
}

/// Each side of a clip box is moved outward by this margin, one unit of 2^-28. Hit points are
/// rounded. Without the margin, gaps would appear between adjacent planes.
const EDGE: i32 = 1;

/// If the magnitude of a coordinate is below this limit, rounding cannot move the coordinate
/// out of the near range (±3.5).
const SURELY_NEAR: i32 = NEAR - 16;

impl ClipBox {
    /// A box without bounds.
    pub(crate) const UNBOUNDED: Self = Self {
        low: Vec3::new(Length::MIN, Length::MIN, Length::MIN),
        high: Vec3::new(Length::MAX, Length::MAX, Length::MAX),
    };

    /// Returns true if the box contains a point.
    pub(crate) fn contains(&self, point: &Point) -> bool {
        if point.is_near() {
            self.contains_near(point.coordinates)
        } else {
            self.contains_extended(*point)
        }
    }

    /// Returns true if the box contains a point in the near range (each coordinate within
    /// ±3.5).
    ///
    /// A coordinate that overflows wraps around to a value outside of the near range. A box
    /// with bounds in the near range therefore rejects the point.
    #[inline(always)]
    pub(crate) fn contains_near(&self, p: Vec3<Length>) -> bool {
        let is_within = |c: Length, low: Length, high: Length| {
            c.to_bits().wrapping_add(EDGE) >= low.to_bits()
                && c.to_bits().wrapping_sub(EDGE) <= high.to_bits()
        };
        let Self { low, high } = self;
        is_within(p.x, low.x, high.x)
            && is_within(p.y, low.y, high.y)
            && is_within(p.z, low.z, high.z)
    }

    #[cold]
    fn contains_extended(&self, point: Point) -> bool {
        let is_within = |c, low, high| is_within_extended(c, point.shift, low, high);
        let (p, Self { low, high }) = (point.coordinates, self);
        is_within(p.x, low.x, high.x)
            && is_within(p.y, low.y, high.y)
            && is_within(p.z, low.z, high.z)
    }

    /// Returns true if the clipped plane lies in the near range (each coordinate within ±3.5).
    /// The result is exact for bounded planes and floors. For other planes, the result may be
    /// false although the clipped plane is in the near range.
    pub(crate) fn is_near(&self, normal: Vec3<Unit>, offset: i64) -> bool {
        let near = self.low.zip(self.high, are_both_near);
        let n = normal.map(Unit::to_bits);
        let is_offset_near = offset.abs() < i64::from(SURELY_NEAR);
        (near.x || is_offset_near && n.y | n.z == 0)
            && (near.y || is_offset_near && n.x | n.z == 0)
            && (near.z || is_offset_near && n.x | n.y == 0)
    }
}

/// Returns true if the coordinate `c` lies between `low` and `high`. The unit of `c` is
/// `2^(shift - 28)`. There is no lower bound if `low` is [`Length::MIN`], and no upper bound if
/// `high` is [`Length::MAX`].
fn is_within_extended(c: Length, shift: u8, low: Length, high: Length) -> bool {
    let (c, edge) = (i64::from(c.to_bits()) << shift, i64::from(EDGE));
    (low == Length::MIN || c + edge >= i64::from(low.to_bits()))
        && (high == Length::MAX || c - edge <= i64::from(high.to_bits()))
}

fn are_both_near(low: Length, high: Length) -> bool {
    let is_near = |end: Length| end.to_bits().unsigned_abs() < SURELY_NEAR as u32;
    is_near(low) && is_near(high)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_clip_box_is_widened_by_one_step() {
        let length = Length::from_bits;
        let clip_box = ClipBox {
            low: Vec3::new(length(-100), Length::MIN, length(8)),
            high: Vec3::new(length(50), length(0), Length::MAX),
        };
        let contains = |x, y, z, shift| {
            let coordinates = Vec3::new(x, y, z).map(length);
            clip_box.contains(&Point { coordinates, shift })
        };
        for (x, is_within) in [(-102, false), (-101, true), (51, true), (52, false)] {
            assert_eq!(contains(x, 0, 8, 0), is_within, "x {x}");
        }
        for (y, is_within) in [(-NEAR, true), (1, true), (2, false)] {
            assert_eq!(contains(0, y, 8, 0), is_within, "y {y}");
        }
        for (z, is_within) in [(6, false), (7, true), (NEAR, true)] {
            assert_eq!(contains(0, 0, z, 0), is_within, "z {z}");
        }
        // With a shift of 2, coordinates count in multiples of 4.
        for (x, is_within) in [(-26, false), (-25, true), (12, true), (13, false)] {
            assert_eq!(contains(x, -1, 2, 2), is_within, "4 * {x}");
        }
    }
}
