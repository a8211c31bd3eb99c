use super::exposure::ambient;
use crate::archive::{Archive, Fields};
use crate::geometry::valid;
use crate::math::{
    Color, Factor, Length, Radiance, Real, Weight, factor, power, radiance, reciprocal, weight,
};
use crate::scene::{Scene, SpecularModel};
use crate::{archive, scene};

/// A prepared material, which takes 68 bytes.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Material {
    /// Radiance that does not depend on lights: `le + ka * ia`.
    pub(crate) emitted: Color<Radiance>,
    pub(crate) kd: Color<Factor>,
    pub(crate) ks: Color<Factor>,
    pub(crate) kr: Color<Weight>,
    pub(crate) kt: Color<Weight>,
    /// Exponent of the highlight as `U16F16`, from 1 to 4096.
    pub(crate) shininess: u32,
    /// True if the material reflects or transmits rays. Compiled scenes do not store this
    /// field, because decoding computes it.
    pub(crate) is_specular: bool,
    /// The highlight of the material is visible only if the cosine of its angle is at least
    /// this number, a `U1F31`. The number is above 1 if the material has no visible highlight.
    /// Compiled scenes do not store this field, because decoding computes it.
    pub(crate) min_highlight_cosine: u32,
    /// Index of refraction, from 1 to 4.
    pub(crate) ior: Length,
    /// Reciprocal of the index of refraction.
    pub(crate) inverse_ior: Length,
    /// True for Blinn-Phong highlights, false for Phong ones.
    pub(crate) is_blinn: bool,
}

impl Material {
    /// A black material, which reflects nothing.
    pub(crate) const BLACK: Self = Self {
        emitted: Color::<Radiance>::BLACK,
        kd: Color::<Factor>::BLACK,
        ks: Color::<Factor>::BLACK,
        kr: Color::<Weight>::BLACK,
        kt: Color::<Weight>::BLACK,
        shininess: 0,
        is_specular: false,
        min_highlight_cosine: 0,
        ior: Length::ONE,
        inverse_ior: Length::ONE,
        is_blinn: false,
    };

    /// Prepares a material of a scene.
    pub(super) fn new(material: &scene::Material, scene: &Scene<'_>, exposure: u8) -> Self {
        let coefficient = |color: Color<Real>| color.map(|c| factor(c, 0));
        let emitted = material.le.zip(ambient(material, scene), |le, ambient| {
            radiance(le + ambient, exposure)
        });
        let model = material.shading.unwrap_or(scene.shading);
        // A number that the material does not use is not validated and may have any value, so
        // it is replaced by 1.
        let used = |value, color| match color == Color::gray(Real::ZERO) {
            true => Real::ONE,
            false => value,
        };
        let shininess = used(material.shininess, material.ks);
        let ior = used(material.ior, material.kt);
        let shift = ior.to_bits().leading_zeros();
        let inverse = u64::from(reciprocal((((ior.to_bits() as u64) << shift) >> 32) as u32));
        // Converts the reciprocal of the index of refraction to Q28. Before, it is U1F31 times
        // 2^(shift - 32).
        let inverse = ((inverse << shift) + (1 << 34)) >> 35;
        Self {
            emitted,
            kd: coefficient(material.kd),
            ks: coefficient(material.ks),
            kr: material.kr.map(weight),
            kt: material.kt.map(weight),
            shininess: (shininess.to_bits() >> 16) as u32,
            ior: Length::from_bits(((ior.to_bits() + 8) >> 4) as i32),
            inverse_ior: Length::from_bits(inverse as i32),
            is_blinn: model == SpecularModel::BlinnPhong,
            ..Self::BLACK
        }
        .with_derived_fields()
    }

    /// Returns the material with its derived fields computed.
    pub(crate) fn with_derived_fields(self) -> Self {
        Self {
            is_specular: !self.kr.is_black() || !self.kt.is_black(),
            min_highlight_cosine: if self.ks.is_black() {
                u32::MAX
            } else {
                min_highlight_cosine(self.shininess)
            },
            ..self
        }
    }

    /// Returns true if every field is within its valid range. Tracing relies on these ranges.
    pub(crate) fn is_valid(&self) -> bool {
        valid::are_factors([self.kd, self.ks])
            && (1 << 16..=4096 << 16).contains(&self.shininess)
            && (Length::ONE..=const { Length::lit("4") }).contains(&self.ior)
            && (Length::ONE / 4..=Length::ONE).contains(&self.inverse_ior)
    }
}

impl Fields for Material {
    fn visit(&mut self, archive: &mut impl Archive) {
        archive::color(&mut self.emitted, archive);
        archive::color(&mut self.kd, archive);
        archive::color(&mut self.ks, archive);
        archive::color(&mut self.kr, archive);
        archive::color(&mut self.kt, archive);
        self.shininess.visit(archive);
        archive::fixed(&mut self.ior, archive);
        archive::fixed(&mut self.inverse_ior, archive);
        let mut is_blinn = u8::from(self.is_blinn);
        is_blinn.visit(archive);
        self.is_blinn = is_blinn != 0;
    }
}

/// Returns the smallest cosine, as `U1F31`, at which a highlight with this exponent is visible.
/// A highlight is visible if the cosine, raised to the exponent, is at least half a unit of a
/// [`Factor`]. `exponent` is a `U16F16` of at least 1. For an integer exponent, the result may
/// be one unit too small.
fn min_highlight_cosine(exponent: u32) -> u32 {
    // Ignores the fraction of the exponent, because the fraction could only increase the
    // result.
    let is_invisible = |base| power(base, exponent >> 16 << 16) < 1 << 15;
    let (mut invisible, mut visible) = (0, 1 << 31);
    while visible - invisible > 1 {
        let middle = (invisible + visible) / 2;
        if is_invisible(middle) {
            invisible = middle;
        } else {
            visible = middle;
        }
    }
    visible
}
