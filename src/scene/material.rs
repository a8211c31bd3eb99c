use crate::math::{Color, Real};

/// How a surface reflects and transmits light (Whitted 1980, Phong 1975).
///
/// Coefficients are colors of 0 to 1 a channel; `le` is up to 256.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Material {
    /// Ambient reflection.
    pub ka: Color<Real>,
    /// Diffuse (Lambert) reflection.
    pub kd: Color<Real>,
    /// Specular reflection of lights: the highlight.
    pub ks: Color<Real>,
    /// Exponent of the highlight, 1 to 4096. Read only where `ks` is not black.
    pub shininess: Real,
    /// Weight of the reflected ray.
    pub kr: Color<Real>,
    /// Weight of the transmitted ray, and what is left of light at each crossing.
    pub kt: Color<Real>,
    /// Index of refraction, 1 to 4; see [`ior`]. Read only where `kt` is not black.
    pub ior: Real,
    /// Emission, 0 to 256 a channel.
    pub le: Color<Real>,
    /// Highlight model; `None` takes the scene's.
    pub shading: Option<SpecularModel>,
}

impl Material {
    /// All colors black, to be completed by a struct update.
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

/// A material's place in [`Scene::materials`](crate::Scene::materials).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MaterialId(pub u16);

/// How highlights are shaped.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SpecularModel {
    /// By the angle between the mirrored light and the eye (Phong 1975).
    #[default]
    Phong,
    /// By the angle between the normal and the halfway vector (Blinn 1977).
    BlinnPhong,
}

/// Indices of refraction.
pub mod ior {
    use crate::math::Real;

    /// 1
    pub const VACUUM: Real = Real::ONE;
    /// 1.000292
    pub const AIR: Real = Real::lit("1.000292");
    /// 1.11
    pub const PLASTIC: Real = Real::lit("1.11");
    /// 1.22
    pub const GLASS: Real = Real::lit("1.22");
    /// 1.33
    pub const WATER: Real = Real::lit("1.33");
    /// 1.362
    pub const ALCOHOL: Real = Real::lit("1.362");
    /// 2.417
    pub const DIAMOND: Real = Real::lit("2.417");

    /// All of them by name.
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
