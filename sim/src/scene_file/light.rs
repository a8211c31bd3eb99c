use whitted::Light;

use super::error::LoadError;
use super::name::name;
use super::schema::LIGHT;
use super::table::Table;
use super::value::Value;

/// A light and its name.
pub(super) struct NamedLight<'a> {
    pub(super) light: Light,
    pub(super) name: Option<Value<'a>>,
}

/// Reads a light, with one color or with separate diffuse and specular colors.
pub(super) fn light<'a>(value: &Value<'a>) -> Result<NamedLight<'a>, LoadError> {
    let table = Table::open(value, LIGHT)?;
    let position = table.need("position")?.vector()?;
    let parts = (table.get("diffuse"), table.get("specular"));
    let light = match (table.get("color"), parts) {
        (Some(color), (None, None)) => Light::point(position, color.color()?),
        (Some(color), _) => {
            return Err(color
                .error("cannot be combined with `diffuse` or `specular`")
                .help("keep either `color`, or both `diffuse` and `specular`"));
        }
        (None, (None, None)) => {
            return Err(table
                .missing("color", LIGHT.name)
                .help("add `color = [1.0, 1.0, 1.0]`, or both `diffuse` and `specular`"));
        }
        (None, (diffuse, specular)) => Light {
            position,
            diffuse: diffuse
                .ok_or_else(|| table.missing("diffuse", "a light with `specular`"))?
                .color()?,
            specular: specular
                .ok_or_else(|| table.missing("specular", "a light with `diffuse`"))?
                .color()?,
        },
    };
    let name = name(&table)?;
    Ok(NamedLight { light, name })
}
