use crate::archive;
use crate::archive::{Archive, Fields};
use crate::geometry::{SurfaceFlags, valid};
use crate::math::{Color, Factor, Length, Vec3};

/// A prepared point light, which takes 28 bytes.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Light {
    pub(crate) position: Vec3<Length>,
    pub(crate) diffuse: Color<Factor>,
    pub(crate) specular: Color<Factor>,
    /// True if an unbounded object may occlude a bounded one from this light. The field is
    /// derived, so compiled scenes do not store it.
    pub(crate) is_occluded_by_planes: bool,
    /// Flag that an object has if nothing can occlude it from this light. From the ninth light
    /// on, no flag is left and this set is empty. The flag is derived, so compiled scenes do
    /// not store it.
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

    /// Returns true if every field is within the range that tracing relies on.
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
