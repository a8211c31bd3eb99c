use long_multiply::IS_CALL;

use crate::geometry::{HORIZON, NEAR, Point, Ray};
use crate::math::{
    Length, NEAR_LIMIT, Product, SoftFloat, Unit, Vec3, leading_zeros, outlined as rare, quotient,
    reciprocal, rounded, scaled, wide,
};

/// A plane, endless or bounded.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Plane {
    pub(crate) normal: Vec3<Unit>,
    /// `normal · p` for the points of the plane, in steps of a [`Length`] but
    /// with more range: a plane may be far from all else.
    pub(crate) offset: i64,
    /// What of the plane there is; endless where it says `None`.
    pub(crate) bounds: Option<ClipBox>,
    /// Whether all of it is near: derived.
    is_near: bool,
}

/// A box, endless where a bound is the least or the greatest [`Length`].
#[derive(Clone, Copy, Debug)]
pub(crate) struct ClipBox {
    pub(crate) low: Vec3<Length>,
    pub(crate) high: Vec3<Length>,
}

/// A point of the plane may be rounded away from where it is; so that no ray
/// passes where the edges of two planes meet, each reaches so much farther.
const EDGE: i32 = 1;

impl ClipBox {
    pub(crate) const ENDLESS: Self = Self {
        low: Vec3::new(Length::MIN, Length::MIN, Length::MIN),
        high: Vec3::new(Length::MAX, Length::MAX, Length::MAX),
    };

    #[inline(never)]
    pub(crate) fn contain(&self, point: &Point) -> bool {
        if !point.is_near() {
            return self.contain_far(*point);
        }
        self.contain_near(point.coordinates)
    }

    /// Whether all points within of a plane are near. Of other planes than these, boards
    /// and floors, it need not be known.
    fn are_near(&self, normal: Vec3<Unit>, offset: i64) -> bool {
        let between = self.low.zip(self.high, are_near);
        let n = normal.map(Unit::to_bits);
        let is_level = offset.abs() < i64::from(NEAREST_FAR);
        (between.x || is_level && n.y | n.z == 0)
            && (between.y || is_level && n.x | n.z == 0)
            && (between.z || is_level && n.x | n.y == 0)
    }

    /// The same for a point of a plane that is near wherever it is within; coordinates that
    /// have wrapped are beyond.
    #[inline(always)]
    fn contain_near(&self, p: Vec3<Length>) -> bool {
        let within = |c: Length, low: Length, high: Length| {
            c.to_bits().wrapping_add(EDGE) >= low.to_bits()
                && c.to_bits().wrapping_sub(EDGE) <= high.to_bits()
        };
        let Self { low, high } = self;
        within(p.x, low.x, high.x) && within(p.y, low.y, high.y) && within(p.z, low.z, high.z)
    }

    #[cold]
    #[inline(never)]
    fn contain_far(&self, point: Point) -> bool {
        let within = |c, low, high| is_within(c, point.shift, low, high);
        let (p, Self { low, high }) = (point.coordinates, self);
        within(p.x, low.x, high.x) && within(p.y, low.y, high.y) && within(p.z, low.z, high.z)
    }
}

/// Whether a far coordinate, in steps of `2^shift`, is between two ends. Not inlined, as it
/// is asked for each axis.
#[inline(never)]
fn is_within(c: Length, shift: u8, low: Length, high: Length) -> bool {
    let (c, edge) = (i64::from(c.to_bits()) << shift, i64::from(EDGE));
    (low == Length::MIN || c + edge >= i64::from(low.to_bits()))
        && (high == Length::MAX || c - edge <= i64::from(high.to_bits()))
}

/// A point of the plane is so deep in it at most.
const ROUNDING: i64 = 2;

impl Plane {
    /// Before it is prepared.
    pub(crate) const NONE: Self = Self {
        normal: Vec3::new(Unit::ZERO, Unit::ZERO, Unit::ZERO),
        offset: 0,
        bounds: None,
        is_near: false,
    };

    pub(crate) fn new(normal: Vec3<Unit>, offset: i64, bounds: Option<ClipBox>) -> Self {
        Self {
            normal,
            offset,
            bounds,
            is_near: false,
        }
        .complete()
    }

    /// The plane with what follows from where it is.
    pub(crate) fn complete(self) -> Self {
        let bounds = self.bounds.as_ref();
        Self {
            is_near: bounds.is_some_and(|bounds| bounds.are_near(self.normal, self.offset)),
            ..self
        }
    }

    /// Whether all of it is near.
    #[inline(always)]
    pub(crate) fn is_near(&self) -> bool {
        self.is_near
    }

    /// Whether the normal is y.
    pub(crate) fn is_level(&self) -> bool {
        let n = self.normal;
        n.x == Unit::ZERO && n.y == Unit::ONE && n.z == Unit::ZERO
    }

    /// How far behind the plane a point is, in the point's steps; negative in
    /// front, where the normal points.
    #[inline(never)]
    pub(crate) fn depth(&self, point: Point) -> i64 {
        self.depth_inlined(point)
    }

    /// The same for each shadow ray.
    #[inline(always)]
    fn depth_inlined(&self, point: Point) -> i64 {
        let along = point.coordinates.along(self.normal).to_bits();
        (self.offset >> point.shift) - ((along + (1 << 29)) >> 30)
    }

    /// Whether a point that is so far behind may be on the plane, but for rounding.
    pub(crate) fn may_hold(depth: i64) -> bool {
        depth.abs() <= ROUNDING
    }

    /// Whether a light and a point are on different sides: no distance is
    /// needed to know.
    ///
    /// A point in a corner of walls is on the side of each that it is seen
    /// from, by a ray in the direction of `view`.
    #[inline]
    pub(crate) fn is_between(&self, light: Vec3<Length>, point: Point, view: Vec3<Unit>) -> bool {
        let from = self.depth_inlined(Point::near(light));
        let to = self.depth_inlined(point);
        if Self::may_hold(to) {
            return self.is_seen_from_beyond(from, view);
        }
        from ^ to < 0 && from != 0
    }

    #[cold]
    fn is_seen_from_beyond(&self, from: i64, view: Vec3<Unit>) -> bool {
        let to = view.cosine(self.normal).to_bits();
        from.signum() * i64::from(to.signum()) < 0
    }

    /// How long a vector of any steps, below 2^31, is along the normal.
    #[inline(always)]
    fn along(&self, v: Vec3<i32>) -> i32 {
        let n = self.normal.map(Unit::to_bits);
        // Of most planes, floors, no product is needed to know. Of one that is
        // nearly level y is 1 as well, once rounded.
        if n.x | n.z == 0 && n.y > 0 {
            return v.y;
        }
        let sum = v.x.product(n.x) + v.y.product(n.y) + v.z.product(n.z);
        rounded::<30>(sum)
    }

    /// The distance of a hit from a near point: exact if it is below `limit`,
    /// else anything above or none; [`Length::MAX`] if it is not near.
    #[inline]
    pub(crate) fn distance(&self, ray: &Ray, limit: Length) -> Option<Length> {
        let along = self.along(ray.origin.coordinates.map(Length::to_bits));
        let depth = self.offset - i64::from(along);
        let cosine = self.along(ray.direction.map(Unit::to_bits));
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
        // What is beyond the limit is not worth a division.
        let is_beyond = if IS_CALL && limit == NEAR_LIMIT {
            depth >= 2 * cosine - (cosine >> 20)
        } else {
            u64::from(depth) << 30 >= wide(cosine, limit.to_bits() as u32)
        };
        if is_beyond {
            let is_out_of_reach = self.is_near && is_past_near(ray, limit);
            return (!is_out_of_reach).then_some(Length::MAX);
        }
        let distance = Length::from_bits(ratio(depth, cosine, reciprocal));
        let is_there = match &self.bounds {
            None => true,
            Some(bounds) if self.is_near => bounds.contain_near(ray.near_at(distance)),
            Some(bounds) => bounds.contain(&ray.at(distance)),
        };
        is_there.then_some(distance)
    }

    /// Where the way from a light to a near point crosses the plane, given how far behind it
    /// they are, on different sides.
    #[inline]
    pub(crate) fn crossing(
        &self,
        light: Vec3<Length>,
        way: Vec3<Length>,
        [from, to]: [i64; 2],
    ) -> Vec3<Length> {
        let [from, to] = [from, to].map(|depth| depth.unsigned_abs() as u32);
        // Q30
        let share = ratio(from, from + to, rare::reciprocal);
        light + scaled::<30>(way.map(Length::to_bits), share).map(Length::from_bits)
    }

    /// Whether a point of the plane is within its bounds.
    #[inline]
    pub(crate) fn covers(&self, point: &Point) -> bool {
        self.bounds
            .as_ref()
            .is_none_or(|bounds| bounds.contain(point))
    }

    /// The distance of a hit at any distance from any point.
    #[cold]
    pub(crate) fn far_distance(&self, ray: &Ray) -> Option<SoftFloat> {
        self.unbounded_distance(ray)
            .filter(|distance| self.bounds.is_none() || self.covers(&ray.far_at(*distance)))
    }

    /// The same, without regard to bounds.
    #[inline(never)]
    pub(crate) fn unbounded_distance(&self, ray: &Ray) -> Option<SoftFloat> {
        let (depth, cosine) = self.approach(self.depth(ray.origin), ray.direction)?;
        // Q28 / Q60 -> Q-32 -> Q28 times 2^30, as a quotient is.
        let distance = quotient(depth, cosine);
        let distance = SoftFloat {
            exponent: distance.exponent + 30 + i32::from(ray.origin.shift),
            ..distance
        };
        (distance.exponent <= HORIZON).then_some(distance)
    }

    /// How far the plane is along its normal and the cosine to it, Q60 as it is small for
    /// what is far, both positive, if the ray approaches the plane.
    #[inline(always)]
    fn approach(&self, depth: i64, direction: Vec3<Unit>) -> Option<(u64, u64)> {
        let cosine = direction.dot(self.normal).to_bits();
        if depth ^ cosine < 0 || cosine == 0 || depth == 0 {
            return None;
        }
        Some((depth.unsigned_abs(), cosine.unsigned_abs()))
    }
}

/// `2^30 a / b`, rounded, below 2^31.
#[inline(always)]
fn ratio(a: u32, b: u32, reciprocal: impl Fn(u32) -> u32) -> i32 {
    let shift = leading_zeros(b) & 31;
    // 1/b = reciprocal * 2^(shift - 63)
    let product = wide(a, reciprocal(b << shift));
    let twice = ((product >> 32) as u32) << shift | (product as u32 >> 1) >> (31 - shift);
    (twice.wrapping_add(1) >> 1) as i32
}

/// What is below is near for sure.
const NEAREST_FAR: i32 = NEAR - 16;

#[inline(never)]
fn are_near(low: Length, high: Length) -> bool {
    let is_near = |end: Length| end.to_bits().unsigned_abs() < NEAREST_FAR as u32;
    is_near(low) && is_near(high)
}

/// Whether a ray has left all that is near after a distance: if it was told so by the
/// upper halves of words, along one axis.
fn is_past_near(ray: &Ray, distance: Length) -> bool {
    let distance = (distance.to_bits() >> 16) as u32;
    let is_past = |from: Length, direction: Unit| {
        // Q14 * Q12 next to Q26
        let way = (direction.to_bits().unsigned_abs() >> 16) * distance;
        way > ((NEAR as u32 + from.to_bits().unsigned_abs()) >> 2) + 1
    };
    let (o, d) = (ray.origin.coordinates, ray.direction);
    is_past(o.x, d.x) || is_past(o.y, d.y) || is_past(o.z, d.z)
}

#[cfg(test)]
mod tests {
    extern crate std;

    use fastrand::Rng;
    use std::println;

    use super::*;
    use crate::geometry::OriginSurface;
    use crate::math::{NEAR_LIMIT, direction};

    fn vector(random: &mut Rng, reach: f64) -> Vec3<Length> {
        let mut c = || Length::from_num((2.0 * random.f64() - 1.0) * reach);
        Vec3::new(c(), c(), c())
    }

    /// It is met where any other is, wherever the ray comes from.
    #[test]
    fn a_plane_that_is_near_is_met_without_regard_to_what_is_far() {
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
            // Towards somewhere between, and not of unit length, as an eye ray.
            let origin = vector(random, 3.4);
            let share = Length::from_num(random.f64());
            let mut to = a.zip(b, |a, b| a + (b - a) * share);
            if bounds.low.y == Length::MIN {
                to.y = Length::from_bits(offset as i32);
            }
            let mut direction = (to - origin).map(|c| Unit::from_bits(c.to_bits() >> 1));
            if random.bool() {
                // Or along it, and far away.
                direction = vector(random, 1.0).map(|c| Unit::from_bits(c.to_bits() << 2));
                direction.y = Unit::from_bits(direction.y.to_bits() >> random.u32(..8));
            }
            let ray = Ray {
                origin: Point::near(origin),
                direction,
                start: OriginSurface::NOWHERE,
            };
            let expected = any.distance(&ray, NEAR_LIMIT);
            let expected = expected.filter(|distance| *distance < NEAR_LIMIT);
            let found = near.distance(&ray, NEAR_LIMIT);
            let is_far = found == Some(Length::MAX);
            assert_eq!(found.filter(|_| !is_far), expected, "{near:?} {ray:?}");
            // Nothing is lost of what is farther away.
            assert!(found.is_some() || any.far_distance(&ray).is_none());
            dropped += i32::from(any.distance(&ray, NEAR_LIMIT).is_some() && found.is_none());
            met += i32::from(expected.is_some());
            passed += i32::from(expected.is_none());
        }
        assert!(
            30 * met > passed && dropped > 0,
            "{met} met, {passed} passed by"
        );
    }

    /// In steps: a quotient and a product are rounded, and depths, which far along the plane
    /// tell on where it is crossed.
    #[test]
    fn the_way_of_a_light_crosses_a_plane_where_it_is() {
        let random = &mut Rng::with_seed(2);
        let (mut worst_off_way, mut worst_off_plane, mut crossed) = (0.0_f64, 0, 0);
        for _ in 0..if cfg!(miri) { 300 } else { 100_000 } {
            let (light, point) = (vector(random, 1.0), vector(random, 3.4));
            let Some(normal) = direction(vector(random, 1.0).map(|c| c.to_bits().into())) else {
                continue;
            };
            let offset = i64::from(Length::from_num(2.0 * random.f64() - 1.0).to_bits());
            let plane = Plane::new(normal, offset, None);
            if !plane.is_between(light, Point::near(point), normal) {
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
        println!("{crossed} ways, {worst_off_way:.2} off them, {worst_off_plane} off the plane");
        assert!(crossed > 90 && worst_off_way < 2.5 && worst_off_plane <= 4);
    }

    #[test]
    fn an_endless_plane_is_not_near() {
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

    #[test]
    fn a_box_holds_a_step_more_than_what_is_between_its_ends() {
        let length = Length::from_bits;
        let bounds = ClipBox {
            low: Vec3::new(length(-100), Length::MIN, length(8)),
            high: Vec3::new(length(50), length(0), Length::MAX),
        };
        let contains = |x, y, z, shift| {
            let coordinates = Vec3::new(x, y, z).map(length);
            bounds.contain(&Point { coordinates, shift })
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
        // In steps of 4.
        for (x, is_within) in [(-26, false), (-25, true), (12, true), (13, false)] {
            assert_eq!(contains(x, -1, 2, 2), is_within, "4 * {x}");
        }
    }
}
