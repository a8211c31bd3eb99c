use fixed::types::I8F56;

use crate::Vec3;
use crate::num::{Length, Unit, square_root};
use crate::vector::round_length;

use super::sight::Sight;

/// A sphere within ±1.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Sphere {
    pub(crate) center: Vec3<Length>,
    pub(crate) radius: Length,
    radius_squared: I8F56,
}

/// What rounding the middle of the chord, at most 8 away, to 2^-28 can do to
/// its square, and more.
const MARGIN: i64 = 1 << 33;

/// How a line passes through a sphere.
struct Approach {
    /// From the ray's origin to the middle of the chord.
    middle: Length,
    /// The square of half the chord.
    discriminant: I8F56,
    /// Whether the origin is outside.
    outside: bool,
}

impl Approach {
    /// Half of the chord.
    #[inline]
    fn half(&self) -> Length {
        Length::from_bits(square_root(self.discriminant.to_bits() as u64) as i32)
    }
}

/// From a point to where a line from it is nearest to a sphere's center, unless
/// the line is too far off, as it is for most spheres.
#[inline(always)]
fn passes_by(sight: &Sight, direction: Vec3<Unit>) -> Option<Length> {
    let middle = round_length(sight.to_center.along(direction).to_bits(), 30);
    let rest = middle.wide_mul(middle).to_bits() + sight.depth;
    (rest + MARGIN >= 0).then_some(middle)
}

impl Sphere {
    pub(crate) fn new(center: Vec3<Length>, radius: Length) -> Self {
        Self {
            center,
            radius,
            radius_squared: radius.wide_mul(radius),
        }
    }

    /// How a point sees it.
    #[inline(always)]
    pub(crate) fn sight(&self, point: Vec3<Length>) -> Sight {
        let to_center = self.center - point;
        Sight {
            to_center,
            depth: (self.radius_squared - to_center.squared()).to_bits(),
        }
    }

    /// The chord of a line that passes through the sphere ahead of a point or
    /// around it.
    ///
    /// The discriminant is `r² - |l|²`, `l` from the center to the chord's
    /// middle: the textbook's `b² - c` loses the bits of a small sphere far
    /// away, which `l` keeps (Haines and others, Ray Tracing Gems 2019, ch. 7).
    #[inline(always)]
    fn approach(&self, sight: &Sight, direction: Vec3<Unit>, middle: Length) -> Option<Approach> {
        let Sight { to_center, depth } = *sight;
        let outside = depth < 0;
        if outside && middle <= Length::ZERO {
            return None;
        }
        let offset = to_center - direction.times(middle);
        let discriminant = self.radius_squared - offset.squared();
        if discriminant < I8F56::ZERO {
            return None;
        }
        Some(Approach {
            middle,
            discriminant,
            outside,
        })
    }

    /// Whether the line from a light crosses the sphere before `distance`.
    #[inline(always)]
    pub(crate) fn is_between(
        &self,
        light: &Sight,
        direction: Vec3<Unit>,
        distance: Length,
    ) -> bool {
        passes_by(light, direction)
            .is_some_and(|middle| self.is_met_before(light, direction, middle, distance))
    }

    #[inline(never)]
    fn is_met_before(
        &self,
        light: &Sight,
        direction: Vec3<Unit>,
        middle: Length,
        distance: Length,
    ) -> bool {
        let Some(approach) = self.approach(light, direction, middle) else {
            return false;
        };
        // The entry is before the chord's middle, the exit after it.
        let rest = distance.saturating_sub(approach.middle);
        let square = rest.wide_mul(rest);
        if approach.outside {
            rest > Length::ZERO || square < approach.discriminant
        } else {
            rest > Length::ZERO && square > approach.discriminant
        }
    }

    /// The distance to the nearest hit ahead.
    #[inline(always)]
    pub(crate) fn distance(&self, origin: &Sight, direction: Vec3<Unit>) -> Option<Length> {
        let middle = passes_by(origin, direction)?;
        self.entered(origin, direction, middle)
    }

    #[inline(never)]
    fn entered(&self, origin: &Sight, direction: Vec3<Unit>, middle: Length) -> Option<Length> {
        let approach = self.approach(origin, direction, middle)?;
        let half = approach.half();
        let distance = if approach.outside {
            approach.middle - half
        } else {
            approach.middle + half
        };
        (distance > Length::ZERO).then_some(distance)
    }

    /// From a point on the sphere through its inside to the other end of the
    /// chord: no root is needed.
    #[inline]
    pub(crate) fn across(&self, origin: Vec3<Length>, direction: Vec3<Unit>) -> Length {
        let to_center = self.center - origin;
        round_length(to_center.along(direction).to_bits(), 29).max(Length::ZERO)
    }

    /// Where the line crosses the sphere ahead of `origin`; both ends in order.
    #[inline]
    pub(crate) fn crossings(&self, origin: &Sight, direction: Vec3<Unit>) -> [Option<Length>; 2] {
        let approach = passes_by(origin, direction)
            .and_then(|middle| self.approach(origin, direction, middle));
        let Some(approach) = approach else {
            return [None, None];
        };
        let half = approach.half();
        let entry = approach.outside.then(|| approach.middle - half);
        [entry, Some(approach.middle + half)]
    }

    /// The outward unit normal at a point of the sphere.
    #[inline]
    pub(crate) fn normal(&self, point: Vec3<Length>) -> Vec3<Unit> {
        (point - self.center).normalized().0
    }
}
