//! Computes the direct lighting of a point. It consists of the emission, the ambient light, and the
//! light of all lights that are visible from the point.

use super::interaction::Interaction;
use super::tracer::Tracer;
use crate::geometry::{ShadowSegment, SurfaceFlags};
use crate::math::{
    Color, Factor, Intensity, Product, Radiance, Square, Unit, high, inverse_length, leading_zeros,
    power, reciprocal_root, wide,
};
use crate::observer::{Observer, to_real};
use crate::prepare::Light;

impl<O: Observer> Tracer<'_, '_, O> {
    /// Sets `sum` to the direct lighting. This is `le + ka ia`, plus `T (kd (L·n) id + ks S is)`
    /// for each light. T is the transmittance between the point and the light. L is the unit
    /// direction to the light, n is the normal, and S is the highlight.
    pub(super) fn direct_lighting(&mut self, at: &Interaction<'_>, sum: &mut Color<Radiance>) {
        *sum = at.material.emitted;
        if !at.material.kd.is_black() {
            for (index, light) in self.scene.lights.iter().enumerate() {
                self.add_light(at, light, index, sum);
            }
        } else if !at.material.ks.is_black() {
            self.add_highlights(at, sum);
        }
    }

    /// Adds the highlights of a surface that has no diffuse reflection.
    #[inline(never)]
    fn add_highlights(&mut self, at: &Interaction<'_>, sum: &mut Color<Radiance>) {
        for (index, light) in self.scene.lights.iter().enumerate() {
            if at.material.is_blinn || at.may_have_highlight(light) {
                self.add_light(at, light, index, sum);
            }
        }
    }

    /// Adds the light that arrives from one light and is reflected toward the ray's origin.
    #[inline(never)]
    fn add_light(
        &mut self,
        at: &Interaction<'_>,
        light: &Light,
        index: usize,
        sum: &mut Color<Radiance>,
    ) {
        // `to_light` is in units of 2^(shift - 28), where `shift` is that of the hit point.
        let to_light = at.ray.origin.to(light.position);
        let is_vertical = at.ray.leaves.flags.intersects(SurfaceFlags::HORIZONTAL);
        let along = to_light.along_normal(at.normal, is_vertical).to_bits();
        if along <= 0 {
            return;
        }
        let inverse = inverse_length(to_light.squared().to_bits() as u64);
        let n_dot_l = inverse.cosine(along);
        let v_dot_l = || inverse.cosine(to_light.along(at.ray.direction).to_bits());
        let highlight = at.highlight(v_dot_l, n_dot_l);
        if highlight == Factor::ZERO && at.material.kd.is_black() {
            return;
        }
        let segment = ShadowSegment {
            light: &light.position,
            to_light,
            inverse,
            ray: &at.ray,
        };
        let mut transmittance = None;
        let is_visible = self.is_visible(&segment, light, index, &mut transmittance);
        self.observer.shadow(
            index as u16,
            is_visible.then(|| transmittance.map_or(to_real(Color::<Factor>::WHITE), to_real)),
        );
        if !is_visible {
            return;
        }
        let attenuated;
        let light = match transmittance {
            None => light,
            Some(transmittance) => {
                attenuated = light.attenuated(transmittance);
                &attenuated
            }
        };
        *sum = sum.plus(at.material.kd.reflect(to_intensity(n_dot_l), light.diffuse));
        if highlight != Factor::ZERO {
            *sum = sum.plus(at.material.ks.reflect(highlight.into(), light.specular));
        }
    }
}

impl Interaction<'_> {
    /// Returns true if a light may cause a visible Phong highlight. Most highlights are too dim to
    /// be visible. This function rejects most of them without computing a square root.
    fn may_have_highlight(&self, light: &Light) -> bool {
        /// The test ignores the low words of its numbers. This margin is greater than the error
        /// that this causes.
        const MARGIN: i32 = 8;
        let to_light = self.ray.origin.to(light.position);
        // The base of the highlight is `2 (L·n)(-V·n) + L·V`. L is the direction to the light, V is
        // the view direction and n is the normal. The code uses the full vector to the light
        // instead of L, so its result is the base times the distance to the light. The dot products
        // have Q58 and are shifted to Q26. The factor -V·n has Q30.
        let along = high(to_light.along(self.normal).to_bits());
        let reflected = along.product(self.cosine.to_bits()) >> 29;
        let across = high(to_light.along(self.ray.direction).to_bits());
        let base = reflected as i32 + across + MARGIN;
        let min_cosine = self.material.min_highlight_cosine >> 16;
        let square = high(to_light.squared().to_bits()) as u32;
        // The squared base has Q52. On the other side, the squared distance has Q30 and the
        // squared cosine has Q24.
        along >= 0
            && base > 0
            && (base.square() as u64) << 2 >= wide(square, min_cosine * min_cosine)
    }

    /// Returns the highlight: `(R_L · -V)^s` in Phong's model, `(H · n)^s` in Blinn's model.
    ///
    /// R_L is the reflected direction of the light, H is the halfway vector, V is the view
    /// direction, n is the normal, and s is the exponent. Neither R_L nor H is computed. The bases
    /// of the two powers follow from three known cosines: `R_L · -V = 2 (L·n)(-V·n) + L·V`, and `H
    /// · n = (L·n - V·n) / |L - V|` with `|L - V|² = 2 - 2 L·V`.
    fn highlight(&self, v_dot_l: impl FnOnce() -> Unit, n_dot_l: Unit) -> Factor {
        if self.material.min_highlight_cosine == u32::MAX {
            return Factor::ZERO;
        }
        let v_dot_l = v_dot_l();
        let base = if self.material.is_blinn {
            let sum = (n_dot_l.to_bits() as u32).wrapping_add(self.cosine.to_bits() as u32);
            // `square` is |L - V|² / 4 as U0F32, for the unit directions L and V. It is at most
            // 1, and it is 0 only if V = L.
            let square = ((1 << 30) - i64::from(v_dot_l.to_bits())) << 1;
            let square = square.clamp(1, i64::from(u32::MAX)) as u32;
            let shift = leading_zeros(square) & !1;
            // The product of Q30 and U1F31 is scaled by 2^(shift/2) / 2 and converted to Q31.
            let product = sum.product(reciprocal_root(square << shift));
            (product >> (31 - shift / 2)) as i64
        } else {
            // The product in I4F60 is converted to Q31, and so is the cosine in Q30.
            ((n_dot_l.product(self.cosine).to_bits() + (1 << 27)) >> 28)
                + (i64::from(v_dot_l.to_bits()) << 1)
        };
        if base < i64::from(self.material.min_highlight_cosine) {
            return Factor::ZERO;
        }
        let highlight = power(base.min(1 << 31) as u32, self.material.shininess);
        Factor::from_bits(((highlight + (1 << 15)) >> 16) as u16)
    }
}

/// Rounds a cosine from 0 to 1 to an intensity. The intensity may exceed 1, but too little to be
/// visible.
fn to_intensity(cosine: Unit) -> Intensity {
    Intensity::from_bits(((cosine.to_bits() + (1 << 13)) >> 14) as u32)
}

#[cfg(test)]
mod tests {
    use fastrand::Rng;

    use super::*;
    use crate::geometry::{OriginSurface, Point, Ray};
    use crate::math::{Length, Vec3, direction};
    use crate::prepare::Material;
    use crate::trace::optics;

    fn vector(random: &mut Rng, reach: f64) -> Vec3<Length> {
        let mut c = || Length::from_num((2.0 * random.f64() - 1.0) * reach);
        Vec3::new(c(), c(), c())
    }

    /// Tests lights from the center of a highlight to beyond its edge, both near the surface
    /// and far away.
    #[test]
    fn visible_highlights_are_kept() {
        let random = &mut Rng::with_seed(1);
        let (mut seen, mut passed) = (0, 0);
        for _ in 0..if cfg!(miri) { 100 } else { 100_000 } {
            let shininess = 2_f64.powf(12.0 * random.f64());
            let material = Material {
                ks: Color::WHITE,
                shininess: (shininess * 65_536.0) as u32,
                ..Material::default()
            };
            let material = material.with_derived_fields();
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
                leaves: OriginSurface::NONE,
            };
            let interaction = Interaction {
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
            let highlight = interaction.highlight(|| across, inverse.cosine(along));
            let may_have_highlight = interaction.may_have_highlight(&light);
            assert!(
                highlight == Factor::ZERO || may_have_highlight,
                "{interaction:?} {light:?}"
            );
            seen += i32::from(highlight != Factor::ZERO);
            passed += i32::from(!may_have_highlight);
        }
        assert!(
            seen > passed && 20 * passed > seen,
            "{seen} visible, {passed} culled"
        );
    }
}
