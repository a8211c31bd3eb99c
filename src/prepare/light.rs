use crate::archive;
use crate::archive::{Archive, Fields};
use crate::geometry::{SurfaceFlags, valid};
use crate::math::{Color, Factor, Length, Real, Vec3, factor};

/// A prepared point light, which takes 28 bytes.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Light {
    pub(crate) position: Vec3<Length>,
    pub(crate) diffuse: Color<Factor>,
    pub(crate) specular: Color<Factor>,
    /// True if an unbounded object may hide a bounded object from this light. Compiled scenes
    /// do not store this field, because decoding computes it.
    pub(crate) is_occluded_by_planes: bool,
    /// The flag of objects that no other object can hide from this light. Only the first eight
    /// lights have such a flag. For other lights, this set of flags is empty. Compiled scenes
    /// do not store this field, because decoding computes it.
    pub(crate) unoccluded: SurfaceFlags,
}

impl Light {
    /// Returns the light with its colors multiplied by a transmittance.
    #[inline(never)]
    pub(crate) fn attenuated(&self, transmittance: Color<Factor>) -> Self {
        Self {
            diffuse: self.diffuse.filtered(transmittance),
            specular: self.specular.filtered(transmittance),
            ..*self
        }
    }

    /// Sets the color for diffuse reflection and for highlights. `exposure` is that of the scene.
    pub(crate) fn set_color(&mut self, color: Color<Real>, exposure: u8) {
        let color = color.map(|c| factor(c, exposure));
        (self.diffuse, self.specular) = (color, color);
    }

    /// Returns true if every field is within its valid range. Tracing relies on these ranges.
    #[inline(never)]
    pub(crate) fn is_valid(&self) -> bool {
        valid::is_within_one(&self.position) && valid::are_factors([self.diffuse, self.specular])
    }
}

impl Fields for Light {
    #[inline(never)]
    fn visit(&mut self, archive: &mut impl Archive) {
        archive::vector(&mut self.position, archive);
        archive::color(&mut self.diffuse, archive);
        archive::color(&mut self.specular, archive);
    }
}
