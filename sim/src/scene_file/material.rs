use toml::de::DeValue;
use whitted::scene::{SpecularModel, ior};
use whitted::{Color, Material, MaterialId, Real};

use super::error::LoadError;
use super::keys::{Keys, Kind};
use super::nearest::advice;
use super::value::Value;

const MATERIAL: Kind = Kind {
    name: "a material",
    keys: &[
        "ka",
        "kd",
        "ks",
        "shininess",
        "kr",
        "kt",
        "ior",
        "le",
        "model",
    ],
};

/// Reads a material.
pub(super) fn material(value: &Value<'_>) -> Result<Material, LoadError> {
    let keys = Keys::of(value, "a table")
        .map_err(|error| error.help("name the material: its keys stand under [materials.NAME]"))?;
    keys.only(MATERIAL)?;
    let color = |key| keys.get(key).map_or(Ok(BLACK), |value| value.color());
    let mut material = Material {
        ka: color("ka")?,
        kd: color("kd")?,
        ks: color("ks")?,
        kr: color("kr")?,
        kt: color("kt")?,
        le: color("le")?,
        ..Material::BLACK
    };
    match keys.get("shininess") {
        Some(value) => material.shininess = value.number()?,
        None if material.ks != BLACK => {
            return Err(keys.missing("shininess", "a material whose `ks` is not black"));
        }
        None => {}
    }
    match keys.get("ior") {
        Some(value) => material.ior = index_of_refraction(&value)?,
        None if material.kt != BLACK => {
            return Err(keys.missing("ior", "a material whose `kt` is not black"));
        }
        None => {}
    }
    material.shading = keys.get("model").as_ref().map(shading).transpose()?;
    Ok(material)
}

const BLACK: Color<Real> = Color::gray(Real::ZERO);

fn index_of_refraction(value: &Value<'_>) -> Result<Real, LoadError> {
    match value.node.get_ref() {
        DeValue::Float(_) | DeValue::Integer(_) => value.number(),
        DeValue::String(name) if name.parse::<Real>().is_err() => {
            value.choice(&ior::NAMED, "a medium with a known index", "the media are")
        }
        _ => Err(value.wrong("a number or a medium's name")),
    }
}

/// A highlight model by its name.
pub(super) fn shading(value: &Value<'_>) -> Result<SpecularModel, LoadError> {
    let choices = [
        ("phong", SpecularModel::Phong),
        ("blinn-phong", SpecularModel::BlinnPhong),
    ];
    value.choice(&choices, "a shading model", "the models are")
}

/// The materials' names, in the file's order.
pub(super) struct Names<'a>(pub(super) Vec<&'a str>);

impl Names<'_> {
    /// The material that a value names.
    pub(super) fn find(&self, value: &Value<'_>) -> Result<MaterialId, LoadError> {
        let name = value.text("a material's name")?;
        let index = self.0.iter().position(|known| *known == name);
        match index.map(u16::try_from) {
            Some(Ok(index)) => Ok(MaterialId(index)),
            Some(Err(_)) => Err(value.error("is beyond the 65536th material")),
            None => Err(value
                .error(format!("there is no material `{name}`"))
                .help(self.advice(name))),
        }
    }

    fn advice(&self, name: &str) -> String {
        if self.0.is_empty() {
            format!("define it in a table [materials.{name}]")
        } else {
            advice(name, self.0.iter().copied(), "the materials are")
        }
    }
}
