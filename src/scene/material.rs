use crate::math::{Color, Real};

/// Coefficients that say how a surface reflects and transmits light (Whitted 1980, Phong 1975).
///
/// Each coefficient is a color with channels from 0 to 1. Only the channels of `le` may be greater
/// than 1.
///
/// ```
/// use whitted::scene::ior;
/// use whitted::{Color, Material, color, real};
///
/// // Red lacquer with a highlight and a faint reflection.
/// let lacquer = Material {
///     ka: color!(0.06, 0.004, 0.003),
///     kd: color!(0.6, 0.04, 0.03),
///     ks: Color::gray(real!(0.6)),
///     shininess: real!(120),
///     kr: Color::gray(real!(0.1)),
///     ..Material::BLACK
/// };
/// let mirror = Material { kr: color!(0.8, 0.82, 0.85), ..Material::BLACK };
/// let glass = Material {
///     kr: Color::gray(real!(0.08)),
///     kt: color!(0.9, 0.95, 0.95),
///     ior: ior::GLASS,
///     ..Material::BLACK
/// };
/// // A material that glows by itself and needs no light.
/// let lamp = Material { le: color!(1, 0.9, 0.6), ..Material::BLACK };
/// # let _ = [lacquer, mirror, glass, lamp];
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Material {
    /// Coefficient of ambient reflection.
    pub ka: Color<Real>,
    /// Coefficient of diffuse (Lambertian) reflection.
    pub kd: Color<Real>,
    /// Coefficient of specular reflection. It is the weight of highlights.
    pub ks: Color<Real>,
    /// Exponent of the highlight, 1 to 4096. The exponent is ignored if `ks` is black.
    pub shininess: Real,
    /// Weight of the reflected ray.
    pub kr: Color<Real>,
    /// Weight of the transmitted ray. A shadow ray uses this weight as the transmittance of the
    /// surface.
    pub kt: Color<Real>,
    /// Index of refraction, 1 to 4. See [`ior`] for common values. The index is ignored if `kt`
    /// is black.
    pub ior: Real,
    /// Emitted radiance, from 0 to 256 per channel.
    pub le: Color<Real>,
    /// Model of the highlight. If it is `None`, the material uses the model of the scene,
    /// [`Scene::shading`](crate::Scene::shading).
    pub shading: Option<SpecularModel>,
}

impl Material {
    /// A material whose coefficients are all black. Use it with struct update syntax to set
    /// only some fields.
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
///
/// ```
/// use whitted::{Material, MaterialId, Object, color, real, vec3};
///
/// const RED: MaterialId = MaterialId(0);
/// const BLUE: MaterialId = MaterialId(1);
/// static MATERIALS: [Material; 2] = [
///     Material { kd: color!(0.6, 0.04, 0.03), ..Material::BLACK },
///     Material { kd: color!(0.03, 0.1, 0.6), ..Material::BLACK },
/// ];
/// let ball = Object::sphere(vec3!(0, 1, 0), real!(1), BLUE);
/// # let _ = (RED, &MATERIALS, ball);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MaterialId(pub u16);

/// Reflection model that highlights are computed with.
///
/// ```
/// use whitted::scene::SpecularModel;
/// use whitted::{Material, color, real};
///
/// let satin = Material {
///     ks: color!(0.4, 0.4, 0.4),
///     shininess: real!(20),
///     shading: Some(SpecularModel::BlinnPhong),
///     ..Material::BLACK
/// };
/// # let _ = satin;
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SpecularModel {
    /// Phong's model (1975). A highlight depends on the angle between the view direction and
    /// the reflected direction of the light.
    #[default]
    Phong,
    /// Blinn's model (1977). A highlight depends on the angle between the normal and the
    /// halfway vector.
    BlinnPhong,
}

/// Indices of refraction of common substances.
///
/// ```
/// use whitted::scene::ior;
/// use whitted::{Material, color};
///
/// let water = Material { kt: color!(0.9, 0.95, 1), ior: ior::WATER, ..Material::BLACK };
/// # let _ = water;
/// ```
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

    /// Indices of refraction, with the names that scene files use for them.
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
