use crate::math::{Color, Real};

/// Coefficients by which a surface reflects and transmits light (Whitted 1980, Phong 1975).
///
/// The coefficients are colors with channels from 0 to 1, except for `le`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Material {
    /// Ambient reflection coefficient.
    pub ka: Color<Real>,
    /// Diffuse (Lambertian) reflection coefficient.
    pub kd: Color<Real>,
    /// Specular reflection coefficient: weight of the highlights of lights.
    pub ks: Color<Real>,
    /// Exponent of the highlight, 1 to 4096. Ignored if `ks` is black.
    pub shininess: Real,
    /// Weight of the reflected ray.
    pub kr: Color<Real>,
    /// Weight of the transmitted ray, and transmittance of the surface for shadow rays.
    pub kt: Color<Real>,
    /// Index of refraction, 1 to 4; see [`ior`]. Ignored if `kt` is black.
    pub ior: Real,
    /// Emitted radiance, 0 to 256 per channel.
    pub le: Color<Real>,
    /// Highlight model; `None` selects [`Scene::shading`](crate::Scene::shading).
    pub shading: Option<SpecularModel>,
}

impl Material {
    /// Material with black coefficients, to be completed by struct update syntax.
    pub const BLACK: Self = Self {
        ka: Color::gray(Real::ZERO),
        kd: Color::gray(Real::ZERO),
        ks: Color::gray(Real::ZERO),
        shininess: Real::ONE,
        kr: Color::gray(Real::ZERO),
        kt: Color::gray(Real::ZERO),
        ior: ior::VACUUM,
        le: Color::gray(Real::ZERO),
        shading: None,
    };
}

impl Default for Material {
    fn default() -> Self {
        Self::BLACK
    }
}

/// Index of a material in [`Scene::materials`](crate::Scene::materials).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MaterialId(pub u16);

/// Model of highlights.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SpecularModel {
    /// Phong (1975): cosine of the angle between the view direction and the reflected light.
    #[default]
    Phong,
    /// Blinn (1977): cosine of the angle between the normal and the halfway vector.
    BlinnPhong,
}

/// Common indices of refraction.
pub mod ior {
    use crate::math::Real;

    /// Index of a vacuum: 1.
    pub const VACUUM: Real = Real::ONE;
    /// Index of air: 1.000292.
    pub const AIR: Real = Real::lit("1.000292");
    /// Index of plastic: 1.11.
    pub const PLASTIC: Real = Real::lit("1.11");
    /// Index of glass: 1.22.
    pub const GLASS: Real = Real::lit("1.22");
    /// Index of water: 1.33.
    pub const WATER: Real = Real::lit("1.33");
    /// Index of alcohol: 1.362.
    pub const ALCOHOL: Real = Real::lit("1.362");
    /// Index of diamond: 2.417.
    pub const DIAMOND: Real = Real::lit("2.417");

    /// Indices of refraction by the names that scene files use.
    pub const NAMED: [(&str, Real); 7] = [
        ("vacuum", VACUUM),
        ("air", AIR),
        ("plastic", PLASTIC),
        ("glass", GLASS),
        ("water", WATER),
        ("alcohol", ALCOHOL),
        ("diamond", DIAMOND),
    ];
}
