use super::exposure::ambient;
use crate::archive::{Archive, Fields};
use crate::geometry::valid;
use crate::math::{
    Color, Factor, Length, Radiance, Real, Weight, factor, power, radiance, reciprocal, weight,
};
use crate::scene::{Scene, SpecularModel};
use crate::{archive, scene};

/// A material: 68 bytes.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Material {
    /// `le + ka * ia`: the radiance that does not depend on lights.
    pub(crate) emitted: Color<Radiance>,
    pub(crate) kd: Color<Factor>,
    pub(crate) ks: Color<Factor>,
    pub(crate) kr: Color<Weight>,
    pub(crate) kt: Color<Weight>,
    /// `U16F16`, 1 to 4096.
    pub(crate) shininess: u32,
    /// True if rays are reflected or transmitted. Derived.
    pub(crate) is_specular: bool,
    /// Least cosine of a visible highlight, `U1F31`; above 1 if no highlight is visible.
    /// Derived.
    pub(crate) min_highlight_cosine: u32,
    /// Index of refraction, 1 to 4.
    pub(crate) ior: Length,
    /// Reciprocal of the index of refraction.
    pub(crate) inverse_ior: Length,
    /// True for Blinn-Phong highlights, false for Phong ones.
    pub(crate) is_blinn: bool,
}

impl Material {
    /// A material that reflects nothing.
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
        // A number that is not used is not validated either, and may have any value.
        let used = |value, color| match color == Color::gray(Real::ZERO) {
            true => Real::ONE,
            false => value,
        };
        let shininess = used(material.shininess, material.ks);
        let ior = used(material.ior, material.kt);
        let shift = ior.to_bits().leading_zeros();
        let inverse = u64::from(reciprocal((((ior.to_bits() as u64) << shift) >> 32) as u32));
        // U1F31 * 2^(shift - 32) -> Q28
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

    /// Computes the derived fields.
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

    /// Returns true if every field is in the range that tracing relies on.
    #[inline(never)]
    pub(crate) fn is_valid(&self) -> bool {
        valid::are_factors([self.kd, self.ks])
            && (1 << 16..=4096 << 16).contains(&self.shininess)
            && (Length::ONE..=const { Length::lit("4") }).contains(&self.ior)
            && (Length::ONE / 4..=Length::ONE).contains(&self.inverse_ior)
    }
}

impl Fields for Material {
    #[inline(never)]
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

/// Least base, `U1F31`, whose power with an exponent from 1, `U16F16`, is at least half a step
/// of a [`Factor`]; or one step less.
fn min_highlight_cosine(exponent: u32) -> u32 {
    // The fraction of the exponent would only raise the base.
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
