//! Spheres.

use fixed::types::I8F56;

use super::bounding_sphere::BoundingSphere;
use super::extent::Extent;
use super::normalization::Normalization;
use super::point::Point;
use super::primitive::{AuthoredShape, Primitive, PrimitivePart, SurfacePoint};
use super::ray::Ray;
use super::shadow_segment::ShadowSegment;
use super::surface::SurfaceFlags;
use super::{limits, valid};
use crate::archive;
use crate::archive::{Archive, Fields};
use crate::math::{
    Length, Real, SoftFloat, Square, Unit, Vec3, inverse_length, round_length, square_root,
};
use crate::observer::{Observer, ShapeKind};
use crate::scene::{SceneError, SceneItem};

/// A sphere in world units.
pub(super) struct Authored {
    pub(super) center: Vec3<Real>,
    pub(super) radius: Real,
}

impl AuthoredShape for Authored {
    type Prepared = Sphere;

    fn validate(&self, item: SceneItem) -> Result<(), SceneError> {
        limits::point(item, "center", self.center)?;
        limits::size(item, "radius", self.radius)
    }

    fn extend(&self, extent: &mut Extent) {
        let radius = self.radius.to_bits();
        extent.add_box(self.center, Vec3::new(radius, radius, radius));
    }

    fn prepare(
        &self,
        normalization: &Normalization,
        item: SceneItem,
    ) -> Result<Sphere, SceneError> {
        limits::resolvable_size(item, "radius", self.radius, normalization)?;
        Ok(Sphere::new(
            normalization.point(self.center),
            normalization.size(self.radius),
        ))
    }
}

/// A sphere in the prepared scene, within ±1.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Sphere {
    center: Vec3<Length>,
    radius: Length,
    radius_squared: I8F56,
}

/// The part of a line that is inside a sphere.
struct Chord {
    /// Vector from the origin of the line to the center of the sphere.
    to_center: Vec3<Length>,
    /// Distance from the origin to the middle of the chord.
    middle: Length,
    /// Square of half the chord's length.
    discriminant: I8F56,
}

impl Chord {
    /// Returns half of the chord's length, at least 2^-28.
    #[inline(always)]
    fn half(&self) -> Length {
        let root = inverse_length(self.discriminant.to_bits() as u64).length();
        Length::from_bits(root as i32)
    }

    /// Returns half of the chord's length. This function calls the square root instead of inlining
    /// it. It is for rare cases, which need small code more than speed.
    fn half_outlined(&self) -> Length {
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

    /// Tag of a sphere in a compiled scene.
    pub(super) fn tag(&self) -> u8 {
        0
    }

    /// Returns the chord of a line, if the line meets the sphere.
    ///
    /// The discriminant is `r² - |l|²`, where r is the radius and l the vector from the center to
    /// the middle of the chord. For a small sphere far away, the textbook formula `b² - c` loses
    /// bits that this formula keeps (Haines and others, Ray Tracing Gems 2019, chapter 7).
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

    /// Returns the chord of a ray and a flag. The flag is true if the origin of the ray is outside
    /// of the sphere. Returns `None` if the ray misses the sphere or the chord is entirely behind
    /// the origin.
    #[inline(always)]
    fn chord_ahead(&self, origin: Vec3<Length>, direction: Vec3<Unit>) -> Option<(Chord, bool)> {
        let chord = self.chord(origin, direction)?;
        let is_outside = self.is_outside(&chord)?;
        Some((chord, is_outside))
    }

    /// Returns true if the origin of the ray is outside of the sphere. Returns `None` if the
    /// chord is entirely behind the origin.
    #[inline(always)]
    fn is_outside(&self, chord: &Chord) -> Option<bool> {
        let is_outside = chord.to_center.squared() > self.radius_squared;
        (!is_outside || chord.middle > Length::ZERO).then_some(is_outside)
    }

    /// Returns two flags. The first is true if a ray enters the sphere before `distance`. The
    /// second is true if the ray leaves the sphere before `distance`. The test needs no square
    /// root.
    #[inline(always)]
    fn crosses_before(
        &self,
        origin: Vec3<Length>,
        direction: Vec3<Unit>,
        distance: Length,
    ) -> [bool; 2] {
        let Some((chord, is_outside)) = self.chord_ahead(origin, direction) else {
            return [false; 2];
        };
        // The entry of the ray is before the middle of the chord, and the exit is after it.
        let rest = distance.saturating_sub(chord.middle);
        let is_past_middle = rest > Length::ZERO;
        let square = rest.square();
        [
            is_outside && (is_past_middle || square < chord.discriminant),
            is_past_middle && square > chord.discriminant,
        ]
    }

    /// Returns the distance of the nearest hit, for a ray that does not start on this sphere.
    #[inline(always)]
    fn distance(&self, origin: Vec3<Length>, direction: Vec3<Unit>) -> Option<Length> {
        /// A ray starts outside of the sphere if its entry is farther away than this distance,
        /// 2^16 units of 2^-28.
        ///
        /// The distance from the center to the chord has an error of at most 1.5 units. If the
        /// radius is r units, half of the chord's length then has an error of at most `sqrt(3 r)`.
        /// This error is less than 2^15 units, because r is at most 2^28.
        const OFF: Length = Length::from_bits(1 << 16);
        let chord = self.chord(origin, direction)?;
        if chord.middle > Length::ZERO {
            let entry = chord.middle - chord.half();
            if entry > OFF {
                return Some(entry);
            }
        }
        self.distance_from_nearby(&chord)
    }

    /// Returns the distance of the nearest hit, for a ray that may start inside the sphere or close
    /// to it.
    #[cold]
    #[inline(never)]
    fn distance_from_nearby(&self, chord: &Chord) -> Option<Length> {
        let is_outside = self.is_outside(chord)?;
        let half = chord.half_outlined();
        let distance = chord.middle + if is_outside { -half } else { half };
        (distance > Length::ZERO).then_some(distance)
    }

    /// Returns the length of the chord for a ray that starts on the sphere and runs through its
    /// inside. The computation needs no square root.
    #[inline(always)]
    fn chord_length(&self, origin: Vec3<Length>, direction: Vec3<Unit>) -> Length {
        let to_center = self.center - origin;
        round_length::<29>(to_center.along(direction).to_bits()).max(Length::ZERO)
    }
}

impl Primitive for Sphere {
    fn is_valid(&self) -> bool {
        valid::is_within_one(&self.center) && valid::is_size(self.radius)
    }

    fn kind(&self) -> ShapeKind {
        ShapeKind::Sphere
    }

    fn flags(&self) -> SurfaceFlags {
        SurfaceFlags::BOUNDED.with(SurfaceFlags::CONVEX, true)
    }

    fn bounding_sphere(&self) -> Option<BoundingSphere> {
        Some(BoundingSphere {
            center: self.center,
            radius: self.radius,
        })
    }

    fn is_sphere(&self) -> bool {
        true
    }

    #[inline(always)]
    fn is_near(&self) -> bool {
        true
    }

    #[inline(always)]
    fn intersect(
        &self,
        ray: &Ray,
        is_origin: bool,
        _: Length,
        _: &mut PrimitivePart,
        observer: &mut impl Observer,
    ) -> Option<Length> {
        let origin = ray.origin.coordinates;
        let distance = if is_origin {
            Some(self.chord_length(origin, ray.direction))
        } else {
            self.distance(origin, ray.direction)
        };
        observer.test(ShapeKind::Sphere, distance.is_some());
        distance
    }

    #[inline(always)]
    fn surface_at(&self, point: &Point, _: &PrimitivePart) -> SurfacePoint {
        SurfacePoint::new((point.coordinates - self.center).normalized().0)
    }

    #[inline(always)]
    fn count_crossings(
        &self,
        segment: &ShadowSegment<'_>,
        is_origin: bool,
        _: bool,
        observer: &mut impl Observer,
    ) -> Option<u8> {
        let direction = -segment.direction_to_light();
        let [entry, exit] = self.crosses_before(*segment.light, direction, segment.near_length());
        // If the lit point is on the inside of this sphere, the segment ends on the surface of the
        // sphere. This end does not count as a crossing.
        let count = u8::from(entry) + u8::from(exit && !is_origin);
        observer.test(ShapeKind::Sphere, count > 0);
        Some(count)
    }

    fn visit_crossings(
        &self,
        segment: &ShadowSegment<'_>,
        is_origin: bool,
        _: &mut impl Observer,
        visit: &mut dyn FnMut(Point) -> bool,
    ) {
        let ray = segment.to_ray();
        let Some((chord, is_outside)) = self.chord_ahead(*segment.light, ray.direction) else {
            return;
        };
        let half = chord.half_outlined();
        let entry = is_outside.then(|| chord.middle - half);
        // If the lit point is on the inside of this sphere, the segment ends on the surface of the
        // sphere. This end does not count as a crossing.
        let exit = (!is_origin).then(|| chord.middle + half);
        for distance in [entry, exit].into_iter().flatten() {
            let is_ahead = distance > Length::ZERO;
            if is_ahead && !segment.visit_at(&ray, SoftFloat::unordered(distance), visit) {
                return;
            }
        }
    }
}

impl Fields for Sphere {
    fn visit(&mut self, archive: &mut impl Archive) {
        let Self {
            mut center,
            mut radius,
            ..
        } = *self;
        archive::vector(&mut center, archive);
        archive::fixed(&mut radius, archive);
        *self = Self::new(center, radius);
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

    /// Tests rays that start close to the surface, most of them nearly tangent to it.
    #[test]
    fn the_shortcut_for_distant_entries_changes_no_distance() {
        let random = &mut Rng::with_seed(1);
        let rays = if cfg!(miri) { 300 } else { 300_000 };
        let mut met = 0;
        for _ in 0..rays {
            let radius = 2_f64.powf(-12.0 * random.f64());
            let sphere = Sphere::new(vector(random, 1.0), Length::from_num(radius));
            let Some(up) = direction(vector(random, 1.0).map(|c| c.to_bits().into())) else {
                continue;
            };
            // Starts the ray inside or outside of the sphere, at 1 to 2^18 units from the surface.
            // The unit is 2^-28.
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
            let exact = exact.and_then(|chord| sphere.distance_from_nearby(&chord));
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
