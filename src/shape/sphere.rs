use fixed::types::I8F56;

use crate::Vec3;
use crate::num::{Length, Square, Unit, inverse_length};
use crate::vector::round_length;

use super::bound::Bound;

/// A sphere within ±1.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Sphere {
    pub(crate) center: Vec3<Length>,
    pub(crate) radius: Length,
    radius_squared: I8F56,
}

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
        if self.discriminant == I8F56::ZERO {
            return Length::ZERO;
        }
        // As `square_root` does, but inlined: it is taken for each sphere in sight.
        let root = inverse_length(self.discriminant.to_bits() as u64).length();
        Length::from_bits(root as i32)
    }
}

impl Sphere {
    pub(crate) fn new(center: Vec3<Length>, radius: Length) -> Self {
        Self {
            center,
            radius,
            radius_squared: radius.square(),
        }
    }

    /// A sphere around all of it: itself.
    pub(crate) fn bounding_sphere(&self) -> Bound {
        Bound {
            center: self.center,
            radius: self.radius,
        }
    }

    /// The chord of a line that passes through the sphere ahead of a point or
    /// around it.
    ///
    /// The discriminant is `r² - |l|²`, `l` from the center to the chord's
    /// middle: the textbook's `b² - c` loses the bits of a small sphere far
    /// away, which `l` keeps (Haines and others, Ray Tracing Gems 2019, ch. 7).
    #[inline(always)]
    fn approach(&self, origin: Vec3<Length>, direction: Vec3<Unit>) -> Option<Approach> {
        let to_center = self.center - origin;
        let middle = round_length(to_center.along(direction).to_bits(), 30);
        let offset = to_center - direction.times(middle);
        let discriminant = self.radius_squared - offset.squared();
        if discriminant < I8F56::ZERO {
            return None;
        }
        let outside = to_center.squared() > self.radius_squared;
        if outside && middle <= Length::ZERO {
            return None;
        }
        Some(Approach {
            middle,
            discriminant,
            outside,
        })
    }

    /// Whether the line from a point enters the sphere, and leaves it, before
    /// `distance`: no root is needed to know.
    #[inline]
    pub(crate) fn is_crossed(
        &self,
        origin: Vec3<Length>,
        direction: Vec3<Unit>,
        distance: Length,
    ) -> [bool; 2] {
        let Some(approach) = self.approach(origin, direction) else {
            return [false; 2];
        };
        // The entry is before the chord's middle, the exit after it.
        let rest = distance.saturating_sub(approach.middle);
        let is_beyond_middle = rest > Length::ZERO;
        let square = rest.square();
        [
            approach.outside && (is_beyond_middle || square < approach.discriminant),
            is_beyond_middle && square > approach.discriminant,
        ]
    }

    /// The distance to the nearest hit ahead.
    #[inline]
    pub(crate) fn distance(&self, origin: Vec3<Length>, direction: Vec3<Unit>) -> Option<Length> {
        let approach = self.approach(origin, direction)?;
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
    pub(crate) fn crossings(
        &self,
        origin: Vec3<Length>,
        direction: Vec3<Unit>,
    ) -> [Option<Length>; 2] {
        let Some(approach) = self.approach(origin, direction) else {
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
