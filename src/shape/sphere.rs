use fixed::types::I8F56;

use crate::Vec3;
use crate::num::{Length, Unit, square_root};
use crate::vector::round_length;

/// A sphere within ±1.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Sphere {
    pub(crate) center: Vec3<Length>,
    pub(crate) radius: Length,
    radius_squared: I8F56,
}

/// What rounding the middle of the chord, at most 8 away, to 2^-28 can do to
/// its square, and more.
const MARGIN: I8F56 = I8F56::from_bits(1 << 33);

/// Where a line passes through a sphere, in distances from the ray's origin.
struct Chord {
    middle: Length,
    half: Length,
    /// Whether the origin is outside.
    outside: bool,
}

impl Sphere {
    pub(crate) fn new(center: Vec3<Length>, radius: Length) -> Self {
        Self {
            center,
            radius,
            radius_squared: radius.wide_mul(radius),
        }
    }

    /// The chord of a line that passes through the sphere ahead of `origin`
    /// or around it.
    ///
    /// The discriminant is `r² - |l|²`, `l` from the center to the chord's
    /// middle: the textbook's `b² - c` loses the bits of a small sphere far
    /// away, which `l` keeps (Haines and others, Ray Tracing Gems 2019, ch. 7).
    #[inline]
    fn chord(&self, origin: Vec3<Length>, direction: Vec3<Unit>) -> Option<Chord> {
        let to_center = self.center - origin;
        let middle = round_length(to_center.along(direction).to_bits(), 30);
        let squared = to_center.squared();
        let outside = squared > self.radius_squared;
        if outside && middle <= Length::ZERO {
            return None;
        }
        if squared - middle.wide_mul(middle) > self.radius_squared + MARGIN {
            return None;
        }
        let offset = to_center - direction.times(middle);
        let discriminant = self.radius_squared - offset.squared();
        if discriminant < I8F56::ZERO {
            return None;
        }
        let half = Length::from_bits(square_root(discriminant.to_bits() as u64) as i32);
        Some(Chord {
            middle,
            half,
            outside,
        })
    }

    /// The distance to the nearest hit ahead.
    #[inline]
    pub(crate) fn distance(&self, origin: Vec3<Length>, direction: Vec3<Unit>) -> Option<Length> {
        let chord = self.chord(origin, direction)?;
        let distance = if chord.outside {
            chord.middle - chord.half
        } else {
            chord.middle + chord.half
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
        let Some(chord) = self.chord(origin, direction) else {
            return [None, None];
        };
        let entry = chord.outside.then(|| chord.middle - chord.half);
        [entry, Some(chord.middle + chord.half)]
    }

    /// The outward unit normal at a point of the sphere.
    #[inline]
    pub(crate) fn normal(&self, point: Vec3<Length>) -> Vec3<Unit> {
        (point - self.center).normalized().0
    }
}
