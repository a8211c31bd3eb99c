use fixed::types::I8F56;

use crate::math::{Length, Square, Unit, Vec3, inverse_length, round_length, square_root};

use crate::geometry::bounds::BoundingSphere;

/// A sphere within ±1.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Sphere {
    pub(crate) center: Vec3<Length>,
    pub(crate) radius: Length,
    radius_squared: I8F56,
}

/// What a sphere cuts out of a line.
struct Chord {
    /// From a point of the line to the sphere's center.
    to_center: Vec3<Length>,
    /// From there to the middle of the chord.
    middle: Length,
    /// The square of half the chord.
    discriminant: I8F56,
}

impl Chord {
    /// Half of the chord, one step at least.
    #[inline]
    fn half(&self) -> Length {
        let root = inverse_length(self.discriminant.to_bits() as u64).length();
        Length::from_bits(root as i32)
    }

    /// The same, not inlined.
    fn half_of_few(&self) -> Length {
        Length::from_bits(square_root(self.discriminant.to_bits().max(1) as u64) as i32)
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
    pub(crate) fn bounding_sphere(&self) -> BoundingSphere {
        BoundingSphere {
            center: self.center,
            radius: self.radius,
        }
    }

    /// The chord of a line, if it meets the sphere.
    ///
    /// The discriminant is `r² - |l|²`, `l` from the center to the chord's
    /// middle: the textbook's `b² - c` loses the bits of a small sphere far
    /// away, which `l` keeps (Haines and others, Ray Tracing Gems 2019, ch. 7).
    #[inline(always)]
    fn chord(&self, origin: Vec3<Length>, direction: Vec3<Unit>) -> Option<Chord> {
        let to_center = self.center - origin;
        let middle = round_length::<30>(to_center.along(direction).to_bits());
        let offset = to_center - direction.times(middle);
        let discriminant = self.radius_squared - offset.squared();
        (discriminant >= I8F56::ZERO).then_some(Chord {
            to_center,
            middle,
            discriminant,
        })
    }

    /// A chord that is ahead of the ray or around its start, and whether it starts
    /// outside.
    #[inline(always)]
    fn approach(&self, origin: Vec3<Length>, direction: Vec3<Unit>) -> Option<(Chord, bool)> {
        let chord = self.chord(origin, direction)?;
        let is_outside = self.is_outside(&chord)?;
        Some((chord, is_outside))
    }

    /// Whether the ray starts outside; `None` if the chord is behind it.
    #[inline(always)]
    fn is_outside(&self, chord: &Chord) -> Option<bool> {
        let is_outside = chord.to_center.squared() > self.radius_squared;
        (!is_outside || chord.middle > Length::ZERO).then_some(is_outside)
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
        let Some((chord, is_outside)) = self.approach(origin, direction) else {
            return [false; 2];
        };
        // The entry is before the chord's middle, the exit after it.
        let rest = distance.saturating_sub(chord.middle);
        let is_beyond_middle = rest > Length::ZERO;
        let square = rest.square();
        [
            is_outside && (is_beyond_middle || square < chord.discriminant),
            is_beyond_middle && square > chord.discriminant,
        ]
    }

    /// The distance to the nearest hit ahead.
    #[inline]
    pub(crate) fn distance(&self, origin: Vec3<Length>, direction: Vec3<Unit>) -> Option<Length> {
        /// An offset is off by a step and a half, and so half a chord by `sqrt(3 r)` at
        /// most, which is less than 2^15 steps: whoever has more than twice that to go
        /// to the entry starts outside.
        const OFF: Length = Length::from_bits(1 << 16);
        let chord = self.chord(origin, direction)?;
        if chord.middle > Length::ZERO {
            let entry = chord.middle - chord.half();
            if entry > OFF {
                return Some(entry);
            }
        }
        self.distance_from_close(&chord)
    }

    /// The same from a point that may be inside.
    #[cold]
    #[inline(never)]
    fn distance_from_close(&self, chord: &Chord) -> Option<Length> {
        let is_outside = self.is_outside(chord)?;
        let half = chord.half_of_few();
        let distance = chord.middle + if is_outside { -half } else { half };
        (distance > Length::ZERO).then_some(distance)
    }

    /// From a point on the sphere through its inside to the other end of the
    /// chord: no root is needed.
    #[inline]
    pub(crate) fn across(&self, origin: Vec3<Length>, direction: Vec3<Unit>) -> Length {
        let to_center = self.center - origin;
        round_length::<29>(to_center.along(direction).to_bits()).max(Length::ZERO)
    }

    /// Where the line crosses the sphere ahead of `origin`; both ends in order.
    #[inline]
    pub(crate) fn crossings(
        &self,
        origin: Vec3<Length>,
        direction: Vec3<Unit>,
    ) -> [Option<Length>; 2] {
        let Some((chord, is_outside)) = self.approach(origin, direction) else {
            return [None, None];
        };
        let half = chord.half_of_few();
        let entry = is_outside.then(|| chord.middle - half);
        [entry, Some(chord.middle + half)]
    }

    /// The outward unit normal at a point of the sphere.
    #[inline]
    pub(crate) fn normal(&self, point: Vec3<Length>) -> Vec3<Unit> {
        (point - self.center).normalized().0
    }
}

#[cfg(test)]
mod tests {
    use fastrand::Rng;

    use super::*;
    use crate::math::direction;

    fn vector(random: &mut Rng, reach: f64) -> Vec3<Length> {
        let mut c = || Length::from_num((2.0 * random.f64() - 1.0) * reach);
        Vec3::new(c(), c(), c())
    }

    /// Rays from close to the surface, most of them almost along it.
    #[test]
    fn where_a_ray_starts_is_asked_wherever_it_matters() {
        let random = &mut Rng::with_seed(1);
        let rays = if cfg!(miri) { 300 } else { 300_000 };
        let mut met = 0;
        for _ in 0..rays {
            let radius = 2_f64.powf(-12.0 * random.f64());
            let sphere = Sphere::new(vector(random, 1.0), Length::from_num(radius));
            let Some(up) = direction(vector(random, 1.0).map(|c| c.to_bits().into())) else {
                continue;
            };
            // In or above the surface by 1 to 2^18 steps.
            let above = (1 << random.u32(..19)) * [-1, 1][random.usize(..2)];
            let origin = sphere.center + up.times(sphere.radius + Length::from_bits(above));
            let Some(other) = direction(vector(random, 1.0).map(|c| c.to_bits().into())) else {
                continue;
            };
            let side = up.cross(other);
            let lean = random.i64(-1 << 30..1 << 30) >> random.u32(..30);
            let along = side.zip(up, |s, u| {
                (s >> 30) + ((i64::from(u.to_bits()) * lean) >> 30)
            });
            let Some(along) = direction(along) else {
                continue;
            };
            let exact = sphere.chord(origin, along);
            let exact = exact.and_then(|chord| sphere.distance_from_close(&chord));
            assert_eq!(
                sphere.distance(origin, along),
                exact,
                "{sphere:?} {origin:?} {along:?}"
            );
            met += i32::from(exact.is_some());
        }
        assert!(3 * met > rays, "{met} of {rays}");
    }
}
