//! The local color of a hit, and the rays that go on from it.
//!
//! Shading never traces: [`crate::tracer`] walks the tree of rays.

use core::ptr;

use crate::intersect::{Hit, Part};
use crate::num::{
    Factor, Product, Radiance, Unit, inverse_length, leading_zeros, power, reciprocal_root,
};
use crate::observer::{Observer, share};
use crate::prepared::{Material, PreparedScene};
use crate::ray::{Nature, Point, Ray, Start};
use crate::shadow::ShadowRay;
use crate::shape::Shape;
use crate::{Color, Vec3, optics};

/// All that shading needs to know of a hit.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Surface<'s> {
    point: Point,
    /// Of the incoming ray.
    view: Vec3<Unit>,
    /// Turned to face the incoming ray.
    normal: Vec3<Unit>,
    /// Of the incoming ray and the normal: `-V · n`, not negative.
    cosine: Unit,
    material: &'s Material,
    /// What a ray that starts here on the same side must not meet again;
    /// `inward` if the ray came from behind the surface.
    start: Start,
}

impl<'s> Surface<'s> {
    #[inline(always)]
    pub(crate) fn new(scene: &PreparedScene<'s>, ray: &Ray, hit: Hit, part: &Part) -> Self {
        let object = scene.object(hit.object);
        let point = hit.point(object, ray);
        let mut path = 0;
        let normal = match &object.shape {
            Shape::Sphere(sphere) => sphere.normal(point.coordinates),
            Shape::Plane(plane) => plane.normal,
            Shape::Quadric(quadric) => quadric.normal(point),
            Shape::Sphereflake(_) => {
                path = part.path;
                part.normal
            }
        };
        let material = scene.material(object.texture.material(point));
        let cosine = ray.direction.cosine(normal);
        let inward = cosine > Unit::ZERO;
        Self {
            point,
            view: ray.direction,
            normal: if inward { -normal } else { normal },
            cosine: cosine.abs(),
            material,
            start: Start::new(hit.object, path, inward, object.nature),
        }
    }

    /// The object's number.
    pub(crate) fn object(&self) -> u16 {
        self.start.object
    }

    /// The material's number: found by its place in the list, as only observers ask.
    pub(crate) fn material(&self, scene: &PreparedScene<'_>) -> u16 {
        let place = ptr::from_ref(self.material).addr();
        let distance = place.wrapping_sub(scene.materials.as_ptr().addr());
        (distance / size_of::<Material>()) as u16
    }

    /// Whether the ray came from behind the surface.
    pub(crate) fn inside(&self) -> bool {
        self.start.inward
    }

    /// Whether it looks the same from everywhere.
    #[inline]
    pub(crate) fn is_matte(&self) -> bool {
        self.material.dimmest == u32::MAX && !self.material.branches
    }

    /// Takes the unit vector of the incoming ray in place of one of another length.
    #[inline]
    pub(crate) fn look_along(&mut self, view: Vec3<Unit>) {
        self.view = view;
        self.cosine = view.cosine(self.normal).abs();
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
        for index in 0..scene.lights.len() {
            self.lit(scene, index, sum, observer);
        }
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
        let way = self.point.to(light.position);
        let along = way.along(self.normal).to_bits();
        if along <= 0 {
            return;
        }
        let inverse = inverse_length(way.squared().to_bits() as u64);
        let cosine = inverse.cosine(along);
        let material = self.material;
        let highlight = if material.dimmest == u32::MAX {
            Factor::ZERO
        } else {
            let across = inverse.cosine(way.along(self.view).to_bits());
            self.highlight(across, cosine, observer)
        };
        if highlight == Factor::ZERO && material.kd.is_black() {
            return;
        }
        let shadow = ShadowRay {
            light,
            way,
            inverse,
            point: &self.point,
            view: &self.view,
            start: &self.start,
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
        let (mut diffuse, mut specular) = (light.diffuse, light.specular);
        if let Some(left) = left {
            (diffuse, specular) = (diffuse.filtered(left), specular.filtered(left));
        }
        *sum = sum.plus(material.kd.reflect(factor(cosine), diffuse));
        if highlight != Factor::ZERO {
            *sum = sum.plus(material.ks.reflect(highlight, specular));
        }
    }

    /// Phong's `(R_L · -V)^s` or Blinn's `(H · n)^s`.
    ///
    /// Both from three cosines, without building the vectors:
    /// `R_L · -V = 2 (L·n)(-V·n) + L·V`, and `H · n = (L·n - V·n) / |L - V|`
    /// with `|L - V|² = 2 - 2 L·V`.
    #[inline]
    fn highlight(&self, across: Unit, cosine: Unit, observer: &mut impl Observer) -> Factor {
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
        observer.highlight();
        let highlight = power(base.min(1 << 31) as u32, self.material.shininess);
        Factor::from_bits(((highlight + (1 << 15)) >> 16) as u16)
    }

    /// What goes on from here.
    #[inline]
    pub(crate) fn shares(&self) -> Shares {
        let Material { kr, kt, .. } = *self.material;
        let mut shares = Shares {
            mirrored: kr,
            transmitted: None,
        };
        if kt.is_black() {
            return shares;
        }
        let direction = if self.start.nature.is(Nature::OPEN) {
            Some(self.view)
        } else {
            self.refracted()
        };
        match direction {
            Some(direction) => shares.transmitted = Some((kt, direction)),
            // Total internal reflection: a perfect mirror.
            None => shares.mirrored = Color::WHITE,
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
        optics::refracted(self.view, self.normal, self.cosine, eta)
    }

    /// The ray that is mirrored here.
    #[inline]
    pub(crate) fn reflected(&self) -> Ray {
        Ray {
            origin: self.point,
            direction: optics::mirrored(self.view, self.normal, self.cosine),
            start: self.start,
        }
    }

    /// The ray that goes through.
    #[inline]
    pub(crate) fn transmitted(&self, refraction: Vec3<Unit>) -> Ray {
        Ray {
            origin: self.point,
            direction: refraction,
            start: self.start.beyond(),
        }
    }
}

/// The share of each ray that goes on from a hit.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Shares {
    pub(crate) mirrored: Color<Factor>,
    /// And where it goes, if there is one.
    pub(crate) transmitted: Option<(Color<Factor>, Vec3<Unit>)>,
}

/// A cosine of 0 to 1 as a factor, rounded.
#[inline(always)]
fn factor(cosine: Unit) -> Factor {
    Factor::from_bits((((cosine.to_bits() + (1 << 14)) >> 15) as u16).min(1 << 15))
}
