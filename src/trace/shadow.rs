//! Finds out if a light is visible from a point of a surface.
//!
//! A fast test handles opaque spheres and planes. It takes no square root and does not compute
//! where the light meets the object. For transparent objects and other shapes, a slower test
//! may compute all points where the light crosses the surface.

use super::tracer::Tracer;
use crate::geometry::{ShadowSegment, SurfaceFlags, Texture, normalize_q16};
use crate::math::{Color, Factor, Length, Weight};
use crate::observer::{Observer, RayKind};
use crate::prepare::{Light, Object};

impl<O: Observer> Tracer<'_, '_, O> {
    /// Returns true if light arrives at the surface point where the segment ends. If transparent
    /// surfaces filter the light, sets `transmittance` to the fraction of the light that
    /// arrives.
    #[inline(always)]
    pub(super) fn is_visible(
        &mut self,
        segment: &ShadowSegment<'_>,
        light: &Light,
        index: usize,
        transmittance: &mut Option<Color<Factor>>,
    ) -> bool {
        self.observer.ray(RayKind::Shadow);
        let scene = self.scene;
        let leaves = &segment.ray.leaves;
        if leaves.flags.intersects(light.unoccluded) && !leaves.is_inside {
            return true;
        }
        let to_light = normalize_q16(segment.to_light.map(Length::to_bits), segment.inverse);
        for cone in scene.light_cones(index) {
            if cone.may_contain(to_light)
                && cone.object != leaves.skipped
                && !self.attenuate(segment, cone.object, transmittance)
            {
                return false;
            }
        }
        if leaves.flags.intersects(SurfaceFlags::BOUNDED)
            && !light.is_occluded_by_planes
            && segment.ray.origin.is_near()
        {
            return true;
        }
        let mut unbounded = scene
            .unbounded
            .iter()
            .filter(|&&object| object != leaves.skipped);
        unbounded.all(|&object| self.attenuate(segment, object, transmittance))
    }

    /// If the segment crosses an object, multiplies `transmittance` by the fraction of the
    /// light that this object lets through. Returns false if no light is left.
    #[inline(never)]
    fn attenuate(
        &mut self,
        segment: &ShadowSegment<'_>,
        index: u16,
        transmittance: &mut Option<Color<Factor>>,
    ) -> bool {
        let object = self.scene.object(index);
        let is_origin = index == segment.ray.leaves.object;
        // Fraction of the light that the surface lets through, if it is the same at all
        // points.
        let kt = match object.texture {
            Texture::Uniform(material) => Some(self.scene.material(material).kt),
            Texture::Checker(_) => None,
        };
        let is_opaque = !cfg!(feature = "glass") || kt.is_some_and(Color::<Weight>::is_black);
        let crossings = object
            .shape
            .count_crossings(segment, is_origin, is_opaque, self.observer);
        if crossings == Some(0) {
            return true;
        }
        if is_opaque {
            return crossings.is_none() && !self.crosses(segment, object, is_origin);
        }
        let before = transmittance.unwrap_or(Color::<Factor>::WHITE);
        let after = match (crossings, kt) {
            (Some(crossings), Some(kt)) => {
                let kt = kt.narrowed();
                (0..crossings).fold(before, |transmittance, _| transmittance.filtered(kt))
            }
            _ => self.filter(segment, object, is_origin, before),
        };
        *transmittance = Some(after);
        !after.is_black()
    }

    /// Returns true if a shadow segment crosses the surface of an object.
    fn crosses(&mut self, segment: &ShadowSegment<'_>, object: &Object, is_origin: bool) -> bool {
        let mut is_crossed = false;
        let mut visit = |_| {
            is_crossed = true;
            false
        };
        object
            .shape
            .visit_crossings(segment, is_origin, self.observer, &mut visit);
        is_crossed
    }

    /// Returns the fraction of the light that is left after an object. At each point where the
    /// shadow segment crosses the surface, multiplies `transmittance` by the fraction that the
    /// surface lets through.
    fn filter(
        &mut self,
        segment: &ShadowSegment<'_>,
        object: &Object,
        is_origin: bool,
        mut transmittance: Color<Factor>,
    ) -> Color<Factor> {
        let scene = self.scene;
        let mut visit = |point| {
            transmittance = transmittance.filtered(scene.transmittance(object, &point));
            !transmittance.is_black()
        };
        object
            .shape
            .visit_crossings(segment, is_origin, self.observer, &mut visit);
        transmittance
    }
}
