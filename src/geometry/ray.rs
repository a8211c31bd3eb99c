//! Rays, and the points that they start from and reach.
//!
//! A prepared scene's finite geometry lies within ±1 of its origin. A point
//! within ±[`NEAR`] is *near* and an exact [`Length`] away. Only planes and
//! endless surfaces have points beyond: they are *far* and kept in coarser steps,
//! so that their largest coordinate still uses its bits. A ray's direction
//! itself is only known to 2^-30, so nothing is lost by it.

use crate::math::{Length, Product, SoftFloat, Unit, Vec3, round_length, rounded};

/// How far near points reach, per coordinate.
///
/// From a near point to the finite geometry it is less than
/// `sqrt(3) * (3.5 + 1) < 8`, which a [`Length`] holds.
pub(crate) const NEAR: i32 = 7 << 27;

/// A hit is passed over from `2^(32 + HORIZON)` steps on: 2^26 times the
/// scene's size, closer to the horizon than the pixels of any display.
///
/// A path of 33 such hits, the longest that a tree of rays has, stays below
/// 2^60 steps, so the shift of a far point stays below 32.
pub(crate) const HORIZON: i32 = 22;

/// A point: `coordinates * 2^shift`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Point {
    pub(crate) coordinates: Vec3<Length>,
    /// 0 for near points.
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

    /// The point in steps of 2^shift, with the shift that fits it.
    fn fitted(mut coordinates: Vec3<i64>, mut shift: u32) -> Self {
        loop {
            let reach = reach(coordinates);
            if reach >= 1 << 30 || shift == 0 && reach > i64::from(NEAR) {
                coordinates = coordinates.map(|c| c >> 1);
                shift += 1;
            } else if shift > 0 && reach < 1 << 28 {
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

    /// From here to a near point, in steps of this point's `2^shift`. Its
    /// length is below 8.
    #[inline(always)]
    pub(crate) fn to(self, near: Vec3<Length>) -> Vec3<Length> {
        near.zip(self.coordinates, |n, c| (n >> u32::from(self.shift)) - c)
    }
}

/// A ray on its way through the scene.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ray {
    pub(crate) origin: Point,
    pub(crate) direction: Vec3<Unit>,
    pub(crate) start: OriginSurface,
}

/// The surface that a ray starts on.
///
/// A start point lies only approximately on its surface, and no distance
/// tells a hit of that surface apart from the start: any epsilon is too small
/// for one scene and too large for another. So a ray knows the object it
/// leaves, whose root `t = 0` is then known to be the start.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct OriginSurface {
    /// The object's number.
    pub(crate) object: u16,
    /// The same, if the ray cannot meet it again; else a number that none has.
    pub(crate) left: u16,
    /// Which of the spheres of a sphereflake; else 0.
    pub(crate) part: u32,
    /// Whether the ray runs through the inside of the object.
    pub(crate) inward: bool,
    pub(crate) nature: SurfaceFlags,
}

/// What an object is to the rays that start on it: few bits, as each ray has them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct SurfaceFlags(u16);

impl SurfaceFlags {
    /// Of nothing.
    pub(crate) const NONE: Self = Self(0);
    /// A ray that starts away from it cannot meet it again.
    pub(crate) const LEFT_OUTWARD: Self = Self(1);
    /// One through its inside cannot.
    pub(crate) const LEFT_INWARD: Self = Self(2);
    pub(crate) const FINITE: Self = Self(4);
    /// It bounds no inside.
    pub(crate) const OPEN: Self = Self(8);
    /// Nothing else reaches into it: a sphere that lets light through.
    pub(crate) const ALONE: Self = Self(16);
    /// Its normal is y: a floor.
    pub(crate) const LEVEL: Self = Self(32);
    /// Nothing hides the side that faces the first light; the bits above are for the seven
    /// lights that follow.
    const IN_VIEW: Self = Self(256);

    /// The mark that nothing hides the side that faces a light; only the first eight have one.
    pub(crate) fn in_view(light: usize) -> Self {
        if light < 8 {
            Self(Self::IN_VIEW.0 << light)
        } else {
            Self::NONE
        }
    }

    /// This, and the other if that is so.
    pub(crate) fn and(self, other: Self, is_so: bool) -> Self {
        if is_so { Self(self.0 | other.0) } else { self }
    }

    /// Whether it is the other, too.
    #[inline(always)]
    pub(crate) fn is(self, other: Self) -> bool {
        self.0 & other.0 != 0
    }
}

impl OriginSurface {
    /// On an object, or a part of it.
    #[inline(always)]
    pub(crate) fn new(object: u16, part: u32, inward: bool, nature: SurfaceFlags) -> Self {
        let is_left = nature.is(if inward {
            SurfaceFlags::LEFT_INWARD
        } else {
            SurfaceFlags::LEFT_OUTWARD
        });
        let left = if is_left {
            object
        } else {
            Self::NOWHERE.object
        };
        Self {
            object,
            left,
            part,
            inward,
            nature,
        }
    }

    /// The same place, where a ray goes to the other side.
    #[inline]
    pub(crate) fn beyond(self) -> Self {
        Self::new(self.object, self.part, !self.inward, self.nature)
    }

    /// In the open: the eye or a light.
    pub(crate) const NOWHERE: Self = Self {
        object: u16::MAX,
        left: u16::MAX,
        part: 0,
        inward: false,
        nature: SurfaceFlags::NONE,
    };
}

impl Ray {
    /// The point at a distance below 8 from a near origin.
    #[inline]
    pub(crate) fn at(&self, distance: Length) -> Point {
        let coordinates = self.near_at(distance);
        if are_near(coordinates) {
            Point::near(coordinates)
        } else {
            self.far_at(SoftFloat::unordered(distance))
        }
    }

    /// The same, if that is near, too.
    #[inline(always)]
    pub(crate) fn near_at(&self, distance: Length) -> Vec3<Length> {
        let origin = self.origin.coordinates;
        // Coordinates reach 3.5 + 8; what wraps lands beyond 4 and is seen to be far.
        origin.zip(self.direction.times(distance), Length::wrapping_add)
    }

    /// The point at any distance from any origin.
    #[cold]
    pub(crate) fn far_at(&self, distance: SoftFloat) -> Point {
        let from = i32::from(self.origin.shift);
        // Both terms in the coarser of the origin's steps and those in which
        // the distance is below 2^30.
        let shift =
            from.max(distance.exponent + 32 - distance.mantissa.leading_zeros() as i32 - 30);
        let down = (shift - distance.exponent) as u32;
        let shifted = distance.mantissa.unbounded_shr(down) as i32;
        let coordinates = self.origin.coordinates.zip(self.direction, |o, d| {
            i64::from(o.to_bits() >> (shift - from).min(31))
                + ((d.to_bits().product(shifted) + (1 << 29)) >> 30)
        });
        Point::fitted(coordinates, shift as u32)
    }

    /// Of a ray from a far origin: a ray along it from a near origin, shortly
    /// before all finite geometry, and how many steps of a [`Length`] lie
    /// between the origins. `None` if it passes by, or leaves.
    #[cold]
    pub(crate) fn approaching(&self) -> Option<(Self, i64)> {
        /// Finite geometry is within sqrt(3) of the scene's origin.
        const BEFORE: Length = Length::lit("1.75");
        const REACH: i64 = 2 << 58;

        let Point { coordinates, shift } = self.origin;
        let middle = -coordinates.along(self.direction).to_bits();
        if middle <= 0 {
            return None;
        }
        let middle = rounded::<30>(middle);
        // The ray's foot point, nearest to the scene's origin: far steps, Q58.
        let foot = coordinates.zip(self.direction, |c, d| {
            (i64::from(c.to_bits()) << 30) + d.to_bits().product(middle)
        });
        let passes = |c: i64| c.abs() > REACH >> shift;
        if passes(foot.x) || passes(foot.y) || passes(foot.z) {
            return None;
        }
        let foot = foot.map(|c| shifted_up(c, shift));
        let origin = Point::near(foot - self.direction.times(BEFORE));
        let skipped = (i64::from(middle) << shift) - i64::from(BEFORE.to_bits());
        Some((Self { origin, ..*self }, skipped))
    }
}

/// Whether all are within ±[`NEAR`].
#[inline(always)]
pub(crate) fn are_near(coordinates: Vec3<Length>) -> bool {
    coordinates.all(|c| c.to_bits().wrapping_add(NEAR) as u32 <= 2 * NEAR as u32)
}

/// Q58 in steps of `2^shift` as a near coordinate.
#[inline(never)]
fn shifted_up(c: i64, shift: u8) -> Length {
    round_length::<30>(c << shift)
}

/// The largest coordinate of all.
fn reach(c: Vec3<i64>) -> i64 {
    c.x.abs().max(c.y.abs()).max(c.z.abs())
}
