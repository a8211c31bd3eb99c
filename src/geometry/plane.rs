//! Planes, unbounded or clipped to a box.

pub(super) mod authored;

use super::bounding_sphere::BoundingSphere;
use super::clip_box::ClipBox;
use super::normalization::OFFSET_BITS;
use super::point::{HORIZON, NEAR, Point};
use super::primitive::{Primitive, PrimitivePart, SurfacePoint};
use super::ray::Ray;
use super::shadow_segment::ShadowSegment;
use super::surface::SurfaceFlags;
use super::valid;
use crate::archive::{self, Archive, Fields};
use crate::math::{
    Length, SoftFloat, Unit, Vec3, component_along, leading_zeros, quotient, quotient_reaches,
    reciprocal, reciprocal_outlined, scaled, wide,
};
use crate::observer::{Observer, ShapeKind};

/// Tag of an unbounded plane in a compiled scene.
pub(super) const TAG: u8 = 1;
/// Tag of a clipped plane in a compiled scene.
pub(super) const CLIPPED_TAG: u8 = 2;

/// A plane in the prepared scene.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Plane {
    pub(crate) normal: Vec3<Unit>,
    /// The value of `normal · p`, which is the same for every point `p` of the plane. It is in
    /// units of 2^-28 and has more bits than a [`Length`], because a plane may be far from
    /// everything else.
    offset: i64,
    /// `None` if the plane is unbounded.
    clip_box: Option<ClipBox>,
    /// True if the whole plane is in the near range. Derived from the other fields.
    is_near: bool,
}

/// Largest distance of a rounded hit point from its plane, in the units of the point.
const ROUNDING: i64 = 2;

impl Plane {
    /// A placeholder that no ray hits.
    pub(crate) const NONE: Self = Self {
        normal: Vec3::new(Unit::ZERO, Unit::ZERO, Unit::ZERO),
        offset: 0,
        clip_box: None,
        is_near: false,
    };

    pub(crate) fn new(normal: Vec3<Unit>, offset: i64, clip_box: Option<ClipBox>) -> Self {
        Self {
            normal,
            offset,
            clip_box,
            is_near: clip_box.is_some_and(|clip_box| clip_box.is_near(normal, offset)),
        }
    }

    /// Returns a placeholder plane for a tag of a compiled scene. The decoder then reads the
    /// fields of the plane.
    pub(super) fn of_tag(tag: u8) -> Self {
        let clip_box = (tag == CLIPPED_TAG).then_some(ClipBox::UNBOUNDED);
        Self::new(Vec3::default(), 0, clip_box)
    }

    /// Tag of the plane in a compiled scene.
    pub(super) fn tag(&self) -> u8 {
        match self.clip_box {
            None => TAG,
            Some(_) => CLIPPED_TAG,
        }
    }

    /// Returns true if the normal is exactly +y.
    fn is_horizontal(&self) -> bool {
        let n = self.normal;
        n.x == Unit::ZERO && n.y == Unit::ONE && n.z == Unit::ZERO
    }

    /// Returns how far a point is behind the plane, in the units of the point. The result is
    /// negative in front of the plane, which is the side to which the normal points.
    #[inline(never)]
    pub(crate) fn depth(&self, point: Point) -> i64 {
        self.depth_inlined(point)
    }

    #[inline(always)]
    fn depth_inlined(&self, point: Point) -> i64 {
        let along = point.coordinates.along(self.normal).to_bits();
        (self.offset >> point.shift) - ((along + (1 << 29)) >> 30)
    }

    /// Returns true if a point at this depth may be a rounded hit point of the plane.
    fn may_contain(depth: i64) -> bool {
        depth.abs() <= ROUNDING
    }

    /// Returns true if a light and a point are on different sides of the plane. The test
    /// computes no distance along a ray.
    ///
    /// A point may lie on the plane itself, for example in a corner between planes. Such a
    /// point counts as on the side from which a ray in the direction `view` sees the plane.
    #[inline(always)]
    fn separates(&self, light: Vec3<Length>, point: Point, view: Vec3<Unit>) -> bool {
        let from = self.depth_inlined(Point::near(light));
        let to = self.depth_inlined(point);
        if Self::may_contain(to) {
            return self.is_seen_from_other_side(from, view);
        }
        from ^ to < 0 && from != 0
    }

    #[cold]
    fn is_seen_from_other_side(&self, light_depth: i64, view: Vec3<Unit>) -> bool {
        let cosine = view.cosine(self.normal).to_bits();
        light_depth.signum() * i64::from(cosine.signum()) < 0
    }

    /// Returns the distance from the origin of a ray to its hit. The origin must be in the near
    /// range (each coordinate within ±3.5). The distance is exact if it is below `limit`. For a
    /// hit beyond `limit`, the result is `None` or any distance that is not below `limit`. For a
    /// hit that may be outside of the near range, the result is [`Length::MAX`].
    #[inline(always)]
    fn distance(&self, ray: &Ray, limit: Length) -> Option<Length> {
        let along = component_along(ray.origin.coordinates.map(Length::to_bits), self.normal);
        let depth = self.offset - i64::from(along);
        let cosine = component_along(ray.direction.map(Unit::to_bits), self.normal);
        if (depth >> 32) as i32 ^ cosine < 0 {
            return None;
        }
        let Ok(depth) = i32::try_from(depth) else {
            return (cosine != 0).then_some(Length::MAX);
        };
        let (depth, cosine) = (depth.unsigned_abs(), cosine.unsigned_abs());
        if depth == 0 || cosine == 0 {
            return None;
        }
        // A hit beyond the limit needs no division.
        if quotient_reaches(depth, cosine, limit) {
            let is_out_of_reach = self.is_near && has_left_near_range(ray, limit);
            return (!is_out_of_reach).then_some(Length::MAX);
        }
        let distance = Length::from_bits(ratio(depth, cosine, reciprocal));
        let is_inside = match &self.clip_box {
            None => true,
            Some(clip_box) if self.is_near => clip_box.contains_near(ray.at_near(distance)),
            Some(clip_box) => clip_box.contains(&ray.at(distance)),
        };
        is_inside.then_some(distance)
    }

    /// Returns the point where the segment from a light to a point crosses the plane. The point
    /// must be in the near range (each coordinate within ±3.5). `from` and `to` are the depths
    /// of the light and of the point. They have opposite signs.
    fn crossing(
        &self,
        light: Vec3<Length>,
        to_point: Vec3<Length>,
        [from, to]: [i64; 2],
    ) -> Vec3<Length> {
        let [from, to] = [from, to].map(|depth| depth.unsigned_abs() as u32);
        // Distance from the light to the crossing, as a fraction of the segment, in Q30.
        let share = ratio(from, from + to, reciprocal_outlined);
        light + scaled::<30>(to_point.map(Length::to_bits), share).map(Length::from_bits)
    }

    /// Returns the point where a shadow segment crosses the plane, or `None` if that point is
    /// outside of the clip box. The ends of the segment must be on different sides of the plane.
    #[inline(never)]
    fn segment_crossing(&self, segment: &ShadowSegment<'_>) -> Option<Point> {
        let (light, point) = (*segment.light, segment.ray.origin);
        let depths = [Point::near(light), point].map(|end| self.depth(end));
        let crossing = if point.is_near() {
            Point::near(self.crossing(light, -segment.to_light, depths))
        } else if Self::may_contain(depths[1]) {
            point
        } else {
            let ray = segment.to_ray();
            ray.at_extended(self.unclipped_distance(&ray)?)
        };
        self.is_inside_clip_box(&crossing).then_some(crossing)
    }

    /// Returns true unless the plane has a clip box that does not contain `point`.
    fn is_inside_clip_box(&self, point: &Point) -> bool {
        self.clip_box.as_ref().is_none_or(|b| b.contains(point))
    }

    /// Returns the distance at which a ray hits the plane if the clip box is ignored. The
    /// origin and the hit may be in the near or the extended range.
    #[inline(never)]
    fn unclipped_distance(&self, ray: &Ray) -> Option<SoftFloat> {
        let depth = self.depth(ray.origin);
        // The cosine keeps Q60, because it is small for a distant hit.
        let cosine = ray.direction.dot(self.normal).to_bits();
        if depth ^ cosine < 0 || cosine == 0 || depth == 0 {
            return None;
        }
        // The depth in Q28 divided by the cosine in Q60 gives 2^-32 times the distance, and
        // `quotient` multiplies by 2^30. Adding 30 to the exponent gives units of 2^-28.
        let distance = quotient(depth.unsigned_abs(), cosine.unsigned_abs());
        let distance = SoftFloat {
            exponent: distance.exponent + 30 + i32::from(ray.origin.shift),
            ..distance
        };
        (distance.exponent <= HORIZON).then_some(distance)
    }
}

impl Primitive for Plane {
    fn is_valid(&self) -> bool {
        valid::is_unit(&self.normal) && self.offset.unsigned_abs() < 1 << OFFSET_BITS
    }

    fn kind(&self) -> ShapeKind {
        ShapeKind::Plane
    }

    fn flags(&self) -> SurfaceFlags {
        SurfaceFlags::CONVEX
            .with(SurfaceFlags::FLAT, true)
            .with(SurfaceFlags::OPEN, self.clip_box.is_some())
            .with(SurfaceFlags::HORIZONTAL, self.is_horizontal())
    }

    /// Returns `None`, because a plane is treated as unbounded even if it has a clip box.
    fn bounding_sphere(&self) -> Option<BoundingSphere> {
        None
    }

    #[inline(always)]
    fn is_near(&self) -> bool {
        self.is_near
    }

    #[inline(always)]
    fn intersect(
        &self,
        ray: &Ray,
        _: bool,
        limit: Length,
        _: &mut PrimitivePart,
        observer: &mut impl Observer,
    ) -> Option<Length> {
        let distance = self.distance(ray, limit);
        observer.test(ShapeKind::Plane, distance.is_some());
        distance
    }

    #[cold]
    fn intersect_extended(&self, ray: &Ray, is_origin: bool) -> Option<SoftFloat> {
        if is_origin {
            return None;
        }
        self.unclipped_distance(ray).filter(|distance| {
            self.clip_box.is_none() || self.is_inside_clip_box(&ray.at_extended(*distance))
        })
    }

    fn covers(&self, point: &Point) -> bool {
        self.is_inside_clip_box(point)
    }

    #[inline(always)]
    fn surface_at(&self, _: &Point, _: &PrimitivePart) -> SurfacePoint {
        SurfacePoint::new(self.normal)
    }

    #[inline(always)]
    fn count_crossings(
        &self,
        segment: &ShadowSegment<'_>,
        _: bool,
        any: bool,
        observer: &mut impl Observer,
    ) -> Option<u8> {
        let ray = segment.ray;
        let mut is_crossed = self.separates(*segment.light, ray.origin, ray.direction);
        if is_crossed && self.clip_box.is_some() {
            if !any {
                return None;
            }
            is_crossed = self.segment_crossing(segment).is_some();
        }
        observer.test(ShapeKind::Plane, is_crossed);
        Some(is_crossed.into())
    }

    fn visit_crossings(
        &self,
        segment: &ShadowSegment<'_>,
        _: bool,
        observer: &mut impl Observer,
        visit: &mut dyn FnMut(Point) -> bool,
    ) {
        let crossing = self.segment_crossing(segment);
        observer.test(ShapeKind::Plane, crossing.is_some());
        if let Some(point) = crossing {
            visit(point);
        }
    }

    fn is_disjoint(&self, sphere: &BoundingSphere) -> bool {
        /// Larger than the sum of all rounding errors.
        const MARGIN: Length = Length::lit("0.00001");
        let radius = sphere.radius + MARGIN;
        self.depth(Point::near(sphere.center)).abs() > i64::from(radius.to_bits())
    }

    fn may_separate(&self, point: Vec3<Length>, sphere: &BoundingSphere) -> bool {
        let [from, to] = [point, sphere.center].map(|end| self.depth(Point::near(end)));
        from.signum() != to.signum() || to.abs() < i64::from(sphere.radius.to_bits())
    }
}

impl Fields for Plane {
    fn visit(&mut self, archive: &mut impl Archive) {
        archive::vector(&mut self.normal, archive);
        self.offset.visit(archive);
        if let Some(clip_box) = &mut self.clip_box {
            archive::vector(&mut clip_box.low, archive);
            archive::vector(&mut clip_box.high, archive);
        }
        *self = Self::new(self.normal, self.offset, self.clip_box);
    }
}

/// Returns `2^30 * a / b`, rounded. The result must be below 2^31.
#[inline(always)]
fn ratio(a: u32, b: u32, reciprocal: impl Fn(u32) -> u32) -> i32 {
    let shift = leading_zeros(b) & 31;
    // The reciprocal belongs to `b << shift`, so `1 / b = reciprocal * 2^(shift - 63)`.
    let product = wide(a, reciprocal(b << shift));
    let twice = ((product >> 32) as u32) << shift | (product as u32 >> 1) >> (31 - shift);
    (twice.wrapping_add(1) >> 1) as i32
}

/// Returns true if a ray has left the near range (each coordinate within ±3.5) after the given
/// distance. The test uses only the upper halves of words and one axis at a time. It may
/// therefore return false for a point that is just outside.
fn has_left_near_range(ray: &Ray, distance: Length) -> bool {
    let distance = (distance.to_bits() >> 16) as u32;
    let has_left = |from: Length, direction: Unit| {
        // The direction in Q14 times the distance in Q12 is compared with a sum in Q26.
        let way = (direction.to_bits().unsigned_abs() >> 16) * distance;
        way > ((NEAR as u32 + from.to_bits().unsigned_abs()) >> 2) + 1
    };
    let (o, d) = (ray.origin.coordinates, ray.direction);
    has_left(o.x, d.x) || has_left(o.y, d.y) || has_left(o.z, d.z)
}

#[cfg(test)]
mod tests {
    extern crate std;

    use fastrand::Rng;
    use std::println;

    use super::*;
    use crate::geometry::{NEAR, OriginSurface};
    use crate::math::{NEAR_LIMIT, direction};

    fn vector(random: &mut Rng, reach: f64) -> Vec3<Length> {
        let mut c = || Length::from_num((2.0 * random.f64() - 1.0) * reach);
        Vec3::new(c(), c(), c())
    }

    /// Compares two methods on rays from random origins: the fast one for planes in the near
    /// range, and the general one for all planes.
    #[test]
    fn a_near_plane_has_the_hits_of_any_plane() {
        let random = &mut Rng::with_seed(1);
        let (mut met, mut passed, mut dropped) = (0, 0, 0);
        for _ in 0..if cfg!(miri) { 300 } else { 300_000 } {
            let (a, b) = (vector(random, 1.0), vector(random, 3.4));
            let mut bounds = ClipBox {
                low: a.zip(b, Length::min),
                high: a.zip(b, Length::max),
            };
            let mut normal = random.choice([[0, 1, 0], [1, 0, 0], [0, 0, -1], [3, 4, 5]]);
            if let Some([0, 1, 0]) = normal {
                (bounds.low.y, bounds.high.y) = (Length::MIN, Length::MAX);
            }
            let [x, y, z] = normal.take().unwrap_or_default();
            let Some(normal) = direction(Vec3::new(x, y, z).map(|c: i64| c << 20)) else {
                continue;
            };
            let offset = i64::from(Length::from_num(3.0 * random.f64() - 1.5).to_bits());
            let near = Plane::new(normal, offset, Some(bounds));
            assert!(near.is_near);
            let any = Plane {
                is_near: false,
                ..near
            };
            // Aims the ray at a point inside the clip box. The direction is not a unit vector.
            let origin = vector(random, 3.4);
            let share = Length::from_num(random.f64());
            let mut to = a.zip(b, |a, b| a + (b - a) * share);
            if bounds.low.y == Length::MIN {
                to.y = Length::from_bits(offset as i32);
            }
            let mut direction = (to - origin).map(|c| Unit::from_bits(c.to_bits() >> 1));
            if random.bool() {
                // Makes the ray nearly parallel to the plane, so that its hit tends to be in
                // the extended range.
                direction = vector(random, 1.0).map(|c| Unit::from_bits(c.to_bits() << 2));
                direction.y = Unit::from_bits(direction.y.to_bits() >> random.u32(..8));
            }
            let ray = Ray {
                origin: Point::near(origin),
                direction,
                leaves: OriginSurface::NONE,
            };
            let expected = any.distance(&ray, NEAR_LIMIT);
            let expected = expected.filter(|distance| *distance < NEAR_LIMIT);
            let found = near.distance(&ray, NEAR_LIMIT);
            let is_far = found == Some(Length::MAX);
            assert_eq!(found.filter(|_| !is_far), expected, "{near:?} {ray:?}");
            // The fast path must not lose a hit in the extended range, beyond ±3.5.
            assert!(found.is_some() || any.intersect_extended(&ray, false).is_none());
            dropped += i32::from(any.distance(&ray, NEAR_LIMIT).is_some() && found.is_none());
            met += i32::from(expected.is_some());
            passed += i32::from(expected.is_none());
        }
        assert!(
            30 * met > passed && dropped > 0,
            "{met} met, {passed} missed"
        );
    }

    /// Measures how far the crossing is from the segment and from the plane, in units of 2^-28.
    /// These errors stem from the rounding of a quotient, a product and both depths.
    #[test]
    fn the_crossing_of_a_shadow_segment_is_on_the_plane() {
        let random = &mut Rng::with_seed(2);
        let (mut worst_off_way, mut worst_off_plane, mut crossed) = (0.0_f64, 0, 0);
        for _ in 0..if cfg!(miri) { 300 } else { 100_000 } {
            let (light, point) = (vector(random, 1.0), vector(random, 3.4));
            let Some(normal) = direction(vector(random, 1.0).map(|c| c.to_bits().into())) else {
                continue;
            };
            let offset = i64::from(Length::from_num(2.0 * random.f64() - 1.0).to_bits());
            let plane = Plane::new(normal, offset, None);
            if !plane.separates(light, Point::near(point), normal) {
                continue;
            }
            crossed += 1;
            let sides = [light, point].map(|side| plane.depth(Point::near(side)));
            let crossing = plane.crossing(light, point - light, sides);
            let [from, to] = sides.map(|side| side.abs() as f64);
            for (c, (light, point)) in [crossing.x, crossing.y, crossing.z].into_iter().zip([
                (light.x, point.x),
                (light.y, point.y),
                (light.z, point.z),
            ]) {
                let [c, light, point] = [c, light, point].map(|c| f64::from(c.to_bits()));
                let exact = light + (point - light) * from / (from + to);
                worst_off_way = worst_off_way.max((c - exact).abs());
            }
            worst_off_plane = worst_off_plane.max(plane.depth(Point::near(crossing)).abs());
        }
        println!(
            "{crossed} segments, {worst_off_way:.2} off the line, {worst_off_plane} off the plane"
        );
        assert!(crossed > 90 && worst_off_way < 2.5 && worst_off_plane <= 4);
    }

    #[test]
    fn an_unbounded_plane_is_not_near() {
        let up = Vec3::new(Unit::ZERO, Unit::ONE, Unit::ZERO);
        let one = Vec3::new(Length::ONE, Length::ONE, Length::ONE);
        let bounds = ClipBox {
            low: -one,
            high: one,
        };
        let open = |axis: fn(&mut Vec3<Length>) -> &mut Length| {
            let mut bounds = bounds;
            *axis(&mut bounds.high) = Length::MAX;
            bounds
        };
        let is_near = |offset, bounds| Plane::new(up, offset, bounds).is_near;
        assert!(is_near(0, Some(bounds)));
        assert!(is_near(0, Some(open(|v| &mut v.y))));
        assert!(!is_near(i64::from(NEAR), Some(open(|v| &mut v.y))));
        assert!(!is_near(0, Some(open(|v| &mut v.x))));
        assert!(!is_near(0, Some(open(|v| &mut v.z))));
        assert!(!is_near(0, None));
    }
}
