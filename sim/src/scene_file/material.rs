use toml::de::DeValue;
use whitted::scene::{SpecularModel, ior};
use whitted::{Color, Material, MaterialId, Real};

use super::error::LoadError;
use super::schema::MATERIAL;
use super::suggest::suggestion;
use super::table::Table;
use super::value::Value;
use crate::text::excerpt;

const BLACK: Color<Real> = Color::gray(Real::ZERO);

/// Reads a material. Colors default to black.
pub(super) fn material(value: &Value<'_>) -> Result<Material, LoadError> {
    let table = Table::open_any(value, "a table", MATERIAL.name)
        .map_err(|error| error.help("name the material: write its keys under [materials.NAME]"))?;
    table.reject_unknown(MATERIAL.name, MATERIAL.keys)?;
    let color = |key| table.get(key).map_or(Ok(BLACK), |value| value.color());
    let mut material = Material {
        ka: color("ka")?,
        kd: color("kd")?,
        ks: color("ks")?,
        kr: color("kr")?,
        kt: color("kt")?,
        le: color("le")?,
        ..Material::BLACK
    };
    match table.get("shininess") {
        Some(value) => material.shininess = value.number()?,
        None if material.ks != BLACK => {
            return Err(table.missing("shininess", "a material whose `ks` is not black"));
        }
        None => {}
    }
    match table.get("ior") {
        Some(value) => material.ior = index_of_refraction(&value)?,
        None if material.kt != BLACK => {
            return Err(table.missing("ior", "a material whose `kt` is not black"));
        }
        None => {}
    }
    material.shading = table
        .get("model")
        .as_ref()
        .map(specular_model)
        .transpose()?;
    Ok(material)
}

/// Reads an index of refraction: a number or the name of a medium.
fn index_of_refraction(value: &Value<'_>) -> Result<Real, LoadError> {
    match value.node.get_ref() {
        DeValue::Float(_) | DeValue::Integer(_) => value.number(),
        DeValue::String(name) if name.parse::<Real>().is_err() => {
            value.choice(&ior::NAMED, "a medium with a known index", "the media are")
        }
        _ => Err(value.wrong_type("a number or a medium's name")),
    }
}

/// Reads the name of a specular model.
pub(super) fn specular_model(value: &Value<'_>) -> Result<SpecularModel, LoadError> {
    let choices = [
        ("phong", SpecularModel::Phong),
        ("blinn-phong", SpecularModel::BlinnPhong),
    ];
    value.choice(&choices, "a shading model", "the models are")
}

/// Names of the materials, in the file's order.
pub(super) struct MaterialNames<'a>(pub(super) Vec<&'a str>);

impl MaterialNames<'_> {
    /// Returns the material that a value names.
    pub(super) fn find(&self, value: &Value<'_>) -> Result<MaterialId, LoadError> {
        let name = value.text("a material's name")?;
        let index = self.0.iter().position(|known| *known == name);
        match index.map(u16::try_from) {
            Some(Ok(index)) => Ok(MaterialId(index)),
            Some(Err(_)) => Err(value
                .error("is beyond the 65536th material")
                .help("remove materials that no object uses")),
            None => Err(value
                .error(format!("there is no material `{}`", excerpt(name)))
                .help(self.help_for(name))),
        }
    }

    fn help_for(&self, name: &str) -> String {
        if self.0.is_empty() {
            format!("define it in a table [materials.{}]", excerpt(name))
        } else {
            suggestion(name, self.0.iter().copied(), "the materials are")
        }
    }
}
