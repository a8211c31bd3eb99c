use crate::archive::{Archive, Fields};
use crate::geometry::{MAX_EXPONENT, NEAR, Normalization, valid};
use crate::math::{Color, Factor, Length, Radiance, Real, Unit, Vec3};
use crate::scene::Transfer;
use crate::{archive, scene};

/// Greatest number of generations of secondary rays.
pub(crate) const MAX_DEPTH: u8 = 32;

/// The part of a prepared scene that is not a list.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Settings {
    pub(crate) camera: Camera,
    /// The camera in world units. Orbits start from this camera.
    pub(crate) authored_camera: scene::Camera,
    pub(crate) normalization: Normalization,
    /// Color of the background at and below the horizon.
    pub(crate) horizon: Color<Radiance>,
    /// Color of the background straight up.
    pub(crate) zenith: Color<Radiance>,
    /// True if the colors of horizon and zenith differ. Compiled scenes do not store this
    /// field, because decoding computes it.
    pub(crate) is_gradient: bool,
    /// The radiance in the authored scene is the traced radiance times `2^exposure`.
    pub(crate) exposure: u8,
    pub(crate) max_depth: u8,
    pub(crate) min_weight: Factor,
    /// Transfer function with which renderers start. It is `None` if a compiled scene has an
    /// unknown one, which is not valid.
    pub(crate) transfer: Option<Transfer>,
    /// True if no material of the scene transmits light. Compiled scenes do not store this
    /// field, because decoding computes it.
    pub(crate) is_opaque: bool,
}

impl Settings {
    /// Returns placeholder settings, which decoding overwrites.
    pub(crate) fn empty() -> Self {
        let origin = Vec3::new(Real::ZERO, Real::ZERO, Real::ZERO);
        Self {
            camera: Camera::default(),
            authored_camera: scene::Camera::new(origin, origin, Real::ZERO),
            normalization: Normalization::default(),
            horizon: Color::<Radiance>::BLACK,
            zenith: Color::<Radiance>::BLACK,
            is_gradient: false,
            exposure: 0,
            max_depth: 0,
            min_weight: Factor::ZERO,
            transfer: None,
            is_opaque: false,
        }
    }

    /// Returns true if every field is within its valid range. Tracing relies on these ranges.
    pub(crate) fn is_valid(&self) -> bool {
        let Normalization { center, exponent } = self.normalization;
        let Vec3 { x, y, z } = center.map(i64::unsigned_abs);
        self.camera.is_valid()
            && x | y | z < 1 << 60
            && (-32..=MAX_EXPONENT).contains(&exponent)
            && [self.horizon, self.zenith]
                .into_iter()
                .all(|color| color.all(|c| c <= Radiance::ONE))
            && self.exposure < 16
            && self.max_depth <= MAX_DEPTH
            && self.min_weight <= Factor::ONE
            && self.transfer.is_some()
    }
}

impl Fields for Settings {
    fn visit(&mut self, archive: &mut impl Archive) {
        self.camera.visit(archive);
        let scene::Camera {
            eye,
            look_at,
            up,
            fovy_deg,
        } = &mut self.authored_camera;
        archive::vector(eye, archive);
        archive::vector(look_at, archive);
        archive::vector(up, archive);
        archive::fixed(fovy_deg, archive);
        let Normalization { center, exponent } = &mut self.normalization;
        center.x.visit(archive);
        center.y.visit(archive);
        center.z.visit(archive);
        exponent.visit(archive);
        archive::color(&mut self.horizon, archive);
        archive::color(&mut self.zenith, archive);
        self.is_gradient = self.horizon != self.zenith;
        self.exposure.visit(archive);
        self.max_depth.visit(archive);
        archive::fixed(&mut self.min_weight, archive);
        let mut transfer = self.transfer.unwrap_or_default() as u8;
        transfer.visit(archive);
        self.transfer = match transfer {
            0 => Some(Transfer::Linear),
            1 => Some(Transfer::Srgb),
            _ => None,
        };
    }
}

/// A prepared camera. Its axes are an orthonormal basis.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Camera {
    pub(crate) eye: Vec3<Length>,
    pub(crate) forward: Vec3<Unit>,
    pub(crate) right: Vec3<Unit>,
    pub(crate) up: Vec3<Unit>,
    /// Tangent of half the vertical field of view, as `U4F28`. The tangent is below 11.5.
    pub(crate) tangent: u32,
}

impl Camera {
    fn is_valid(&self) -> bool {
        let Self {
            eye,
            forward,
            right,
            up,
            tangent,
        } = self;
        valid::are_within(eye, Length::from_bits(NEAR))
            && [forward, right, up].into_iter().all(valid::is_unit)
            && valid::are_orthogonal(forward, right)
            && valid::are_orthogonal(right, up)
            && valid::are_orthogonal(up, forward)
            && (1..12 << 28).contains(tangent)
    }
}

impl Fields for Camera {
    fn visit(&mut self, archive: &mut impl Archive) {
        archive::vector(&mut self.eye, archive);
        archive::vector(&mut self.forward, archive);
        archive::vector(&mut self.right, archive);
        archive::vector(&mut self.up, archive);
        self.tangent.visit(archive);
    }
}
