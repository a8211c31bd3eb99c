//! The local color of a hit, and the rays that go on from it.
//!
//! Shading never traces: [`crate::tracer`] walks the tree of rays.

use core::ptr;

use long_multiply::IS_CALL;

use crate::geometry::{OriginSurface, Ray, Shape, SurfaceFlags};
use crate::math::{
    Color, Factor, Intensity, Product, Radiance, Square, Unit, Vec3, Weight, high, inverse_length,
    leading_zeros, power, reciprocal_root, wide,
};
use crate::observer::{Observer, share};
use crate::prepare::{Light, Material, PreparedScene};
use crate::trace::intersect::{Hit, PrimitivePart};
use crate::trace::optics;
use crate::trace::shadow::ShadowRay;

/// All that shading needs to know of a hit, and the ray that met it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Surface<'s> {
    /// It has moved on: from the hit, where it came from behind the surface if it starts
    /// inward.
    ray: Ray,
    /// Turned to face the ray.
    normal: Vec3<Unit>,
    /// Of the ray and the normal: `-V · n`, not negative.
    cosine: Unit,
    material: &'s Material,
}

impl<'s> Surface<'s> {
    /// None yet, but a ray on its way to one.
    #[inline(always)]
    pub(crate) fn ahead_of(ray: Ray) -> Self {
        Self {
            ray,
            normal: Vec3::new(Unit::ZERO, Unit::ZERO, Unit::ZERO),
            cosine: Unit::ZERO,
            material: Material::none(),
        }
    }

    /// The ray.
    #[inline(always)]
    pub(crate) fn ray(&self) -> &Ray {
        &self.ray
    }

    /// Sends another ray on its way.
    #[inline(always)]
    pub(crate) fn follow(&mut self, ray: Ray) {
        self.ray = ray;
    }

    /// Makes the direction of the ray a unit vector.
    #[inline(always)]
    pub(crate) fn make_unit(&mut self) {
        self.ray.direction = self.ray.direction.unit();
    }

    /// Moves the ray on to what it hits.
    #[inline(always)]
    pub(crate) fn meet(&mut self, scene: &PreparedScene<'s>, hit: Hit, part: &PrimitivePart) {
        self.meet_if_there(scene, hit, part, true);
    }

    /// The same for a hit of which it may not be sure that the plane reaches there; false if
    /// it does not.
    #[inline(always)]
    pub(crate) fn meet_if_there(
        &mut self,
        scene: &PreparedScene<'s>,
        hit: Hit,
        part: &PrimitivePart,
        is_sure: bool,
    ) -> bool {
        let object = scene.object(hit.object);
        let ray = &mut self.ray;
        hit.reach(object, ray);
        let mut path = 0;
        let normal = match &object.shape {
            Shape::Sphere(sphere) => sphere.normal(ray.origin.coordinates),
            Shape::Plane(plane) => {
                if !is_sure && !plane.covers(&ray.origin) {
                    return false;
                }
                plane.normal
            }
            Shape::Quadric(quadric) => quadric.normal(ray.origin),
            Shape::Sphereflake(_) => {
                path = part.path;
                part.normal
            }
        };
        let cosine = if IS_CALL && object.nature.is(SurfaceFlags::LEVEL) {
            ray.direction.y
        } else {
            ray.direction.cosine(normal)
        };
        let inward = cosine > Unit::ZERO;
        ray.start = OriginSurface::new(hit.object, path, inward, object.nature);
        self.normal = if inward { -normal } else { normal };
        self.cosine = cosine.abs();
        self.material = scene.material(object.texture.material(&ray.origin));
        true
    }

    /// The object's number.
    pub(crate) fn object(&self) -> u16 {
        self.ray.start.object
    }

    /// The material's number: found by its place in the list, as only observers ask.
    pub(crate) fn material(&self, scene: &PreparedScene<'_>) -> u16 {
        let place = ptr::from_ref(self.material).addr();
        let distance = place.wrapping_sub(scene.materials.as_ptr().addr());
        (distance / size_of::<Material>()) as u16
    }

    /// Whether the ray came from behind the surface.
    pub(crate) fn inside(&self) -> bool {
        self.ray.start.inward
    }

    /// Whether it looks the same from everywhere.
    #[inline]
    pub(crate) fn is_matte(&self) -> bool {
        self.material.dimmest == u32::MAX && !self.material.branches
    }

    /// Makes the direction of a ray a unit vector that has met the surface without being one.
    #[inline(never)]
    pub(crate) fn look_closely(&mut self) {
        self.ray.direction = self.ray.direction.unit_of_few();
        self.cosine = self.ray.direction.cosine(self.normal).abs();
    }

    /// Whether rays go on from here.
    #[inline]
    pub(crate) fn branches(&self) -> bool {
        self.material.branches
    }

    /// `le + ka ia + sum over lights of T (kd (L·n) id + ks S is)`.
    #[inline]
    pub(crate) fn local(
        &self,
        scene: &PreparedScene<'_>,
        sum: &mut Color<Radiance>,
        observer: &mut impl Observer,
    ) {
        *sum = self.material.glow;
        if self.material.kd.is_black() && self.material.ks.is_black() {
            return;
        }
        if self.material.kd.is_black() {
            self.shine(scene, sum, observer);
            return;
        }
        for index in 0..scene.lights.len() {
            self.lit(scene, index, sum, observer);
        }
    }

    /// The same for what has only highlights.
    #[inline(never)]
    fn shine(
        &self,
        scene: &PreparedScene<'_>,
        sum: &mut Color<Radiance>,
        observer: &mut impl Observer,
    ) {
        for (index, light) in scene.lights.iter().enumerate() {
            if self.material.blinn || self.may_shine(light) {
                self.lit(scene, index, sum, observer);
            }
        }
    }

    /// Whether a light may have a highlight of Phong's that can be seen: most are too dim,
    /// and it takes no root to know.
    #[inline(always)]
    fn may_shine(&self, light: &Light) -> bool {
        /// More than what the high words leave out.
        const MARGIN: i32 = 8;
        let way = self.ray.origin.to(light.position);
        // `2 (L·n)(-V·n) + L·V` as long as the way: Q58 -> Q26, of which the first is a
        // product with Q30.
        let along = high(way.along(self.normal).to_bits());
        let mirrored = along.product(self.cosine.to_bits()) >> 29;
        let across = high(way.along(self.ray.direction).to_bits());
        let base = mirrored as i32 + across + MARGIN;
        let dimmest = self.material.dimmest >> 16;
        let square = high(way.squared().to_bits()) as u32;
        // Q52 next to Q30 * Q24
        along >= 0 && base > 0 && (base.square() as u64) << 2 >= wide(square, dimmest * dimmest)
    }

    /// Adds what the surface reflects of one light towards the ray's origin.
    #[inline(never)]
    fn lit(
        &self,
        scene: &PreparedScene<'_>,
        index: usize,
        sum: &mut Color<Radiance>,
        observer: &mut impl Observer,
    ) {
        let Some(light) = scene.lights.get(index) else {
            return;
        };
        // To the light, in steps of the point's shift.
        let way = self.ray.origin.to(light.position);
        let start = &self.ray.start;
        let along = if IS_CALL && start.nature.is(SurfaceFlags::LEVEL) {
            let up = if start.inward { -way.y } else { way.y };
            i64::from(up.to_bits()) << 30
        } else {
            way.along(self.normal).to_bits()
        };
        if along <= 0 {
            return;
        }
        let inverse = inverse_length(way.squared().to_bits() as u64);
        let cosine = inverse.cosine(along);
        let material = self.material;
        let highlight = if material.dimmest == u32::MAX {
            Factor::ZERO
        } else {
            let across = inverse.cosine(way.along(self.ray.direction).to_bits());
            self.highlight(across, cosine)
        };
        if highlight == Factor::ZERO && material.kd.is_black() {
            return;
        }
        let shadow = ShadowRay {
            light,
            way,
            inverse,
            ray: &self.ray,
        };
        let mut left = None;
        let is_lit = shadow.arrives(scene, index, &mut left, observer);
        observer.shadow(
            index as u16,
            is_lit.then_some(left.unwrap_or(Color::WHITE)).map(share),
        );
        if !is_lit {
            return;
        }
        let filtered;
        let light = match left {
            None => light,
            Some(left) => {
                filtered = light.filtered(left);
                &filtered
            }
        };
        *sum = sum.plus(material.kd.reflect(intensity(cosine), light.diffuse));
        if highlight != Factor::ZERO {
            *sum = sum.plus(material.ks.reflect(highlight.into(), light.specular));
        }
    }

    /// Phong's `(R_L · -V)^s` or Blinn's `(H · n)^s`.
    ///
    /// Both from three cosines, without building the vectors:
    /// `R_L · -V = 2 (L·n)(-V·n) + L·V`, and `H · n = (L·n - V·n) / |L - V|`
    /// with `|L - V|² = 2 - 2 L·V`.
    #[inline]
    fn highlight(&self, across: Unit, cosine: Unit) -> Factor {
        let base = if self.material.blinn {
            let sum = (cosine.to_bits() as u32).wrapping_add(self.cosine.to_bits() as u32);
            // |L - V|² / 4, as U0F32, is at most 1 and 0 only against the light.
            let square = ((1 << 30) - i64::from(across.to_bits())) << 1;
            let square = square.clamp(1, i64::from(u32::MAX)) as u32;
            let shift = leading_zeros(square) & !1;
            // Q30 * U1F31 * 2^(shift/2) / 2 -> Q31
            let product = sum.product(reciprocal_root(square << shift));
            (product >> (31 - shift / 2)) as i64
        } else {
            // I4F60 + Q30 -> Q31
            ((cosine.product(self.cosine).to_bits() + (1 << 27)) >> 28)
                + (i64::from(across.to_bits()) << 1)
        };
        if base < i64::from(self.material.dimmest) {
            return Factor::ZERO;
        }
        let highlight = power(base.min(1 << 31) as u32, self.material.shininess);
        Factor::from_bits(((highlight + (1 << 15)) >> 16) as u16)
    }

    /// Whether it lets no light through.
    #[inline]
    pub(crate) fn is_opaque(&self) -> bool {
        self.material.kt.is_black()
    }

    /// How much of it is mirrored where nothing goes through.
    #[inline]
    pub(crate) fn mirrored(&self) -> Color<Weight> {
        self.material.kr
    }

    /// What goes on from here.
    #[inline]
    pub(crate) fn shares(&self) -> Shares {
        let Material { kr, kt, .. } = *self.material;
        let mut shares = Shares {
            mirrored: kr,
            transmitted: None,
        };
        let direction = if self.ray.start.nature.is(SurfaceFlags::OPEN) {
            Some(self.ray.direction)
        } else {
            self.refracted()
        };
        match direction {
            Some(direction) => shares.transmitted = Some((kt, direction)),
            // Total internal reflection: a perfect mirror.
            None => shares.mirrored = Color::<Weight>::ALL,
        }
        shares
    }

    #[cold]
    #[inline(never)]
    fn refracted(&self) -> Option<Vec3<Unit>> {
        let Material {
            ior, inverse_ior, ..
        } = *self.material;
        let eta = if self.inside() { ior } else { inverse_ior };
        optics::refracted(self.ray.direction, self.normal, self.cosine, eta)
    }

    /// Sends the ray on, mirrored.
    #[inline(never)]
    pub(crate) fn reflect(&mut self) {
        self.ray.direction = optics::mirrored(self.ray.direction, self.normal, self.cosine);
    }

    /// The ray that goes through.
    #[inline]
    pub(crate) fn transmitted(&self, refraction: Vec3<Unit>) -> Ray {
        Ray {
            origin: self.ray.origin,
            direction: refraction,
            start: self.ray.start.beyond(),
        }
    }
}

/// The share of each ray that goes on from a hit.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Shares {
    pub(crate) mirrored: Color<Weight>,
    /// And where it goes, if there is one.
    pub(crate) transmitted: Option<(Color<Weight>, Vec3<Unit>)>,
}

/// A cosine of 0 to 1, rounded; what it may be above 1 is too little to be seen here.
#[inline(always)]
fn intensity(cosine: Unit) -> Intensity {
    Intensity::from_bits(((cosine.to_bits() + (1 << 13)) >> 14) as u32)
}

#[cfg(test)]
mod tests {
    use fastrand::Rng;

    use super::*;
    use crate::geometry::Point;
    use crate::math::{Length, direction};

    fn vector(random: &mut Rng, reach: f64) -> Vec3<Length> {
        let mut c = || Length::from_num((2.0 * random.f64() - 1.0) * reach);
        Vec3::new(c(), c(), c())
    }

    /// Lights from where a highlight is brightest to where it vanishes, near and far away.
    #[test]
    fn no_highlight_that_can_be_seen_is_passed_over() {
        let random = &mut Rng::with_seed(1);
        let (mut seen, mut passed) = (0, 0);
        for _ in 0..if cfg!(miri) { 100 } else { 100_000 } {
            let shininess = 2_f64.powf(12.0 * random.f64());
            let material = Material {
                ks: Color::WHITE,
                shininess: (shininess * 65_536.0) as u32,
                ..Material::default()
            };
            let material = material.complete();
            let mut unit = || direction(vector(random, 1.0).map(|c| c.to_bits().into()));
            let (Some(view), Some(normal)) = (unit(), unit()) else {
                continue;
            };
            let cosine = view.cosine(normal);
            let normal = if cosine > 0 { -normal } else { normal };
            let cosine = cosine.abs();
            let ray = Ray {
                origin: Point::near(vector(random, 1.0)),
                direction: view,
                start: OriginSurface::NOWHERE,
            };
            let surface = Surface {
                ray,
                normal,
                cosine,
                material: &material,
            };
            let mirrored = optics::mirrored(view, normal, cosine);
            let distance = Length::from_num(2_f64.powf(-12.0 * random.f64()));
            let aside = vector(random, 4.0 * distance.to_num::<f64>() / shininess.sqrt());
            let light = Light {
                position: ray.origin.coordinates + mirrored.times(distance) + aside,
                ..Light::default()
            };
            let way = ray.origin.to(light.position);
            let along = way.along(normal).to_bits();
            if along <= 0 {
                continue;
            }
            let inverse = inverse_length(way.squared().to_bits() as u64);
            let across = inverse.cosine(way.along(view).to_bits());
            let highlight = surface.highlight(across, inverse.cosine(along));
            let may_shine = surface.may_shine(&light);
            assert!(
                highlight == Factor::ZERO || may_shine,
                "{surface:?} {light:?}"
            );
            seen += i32::from(highlight != Factor::ZERO);
            passed += i32::from(!may_shine);
        }
        assert!(
            seen > passed && 20 * passed > seen,
            "{seen} seen, {passed} not"
        );
    }
}
