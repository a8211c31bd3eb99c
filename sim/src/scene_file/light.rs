use whitted::Light;

use super::error::LoadError;
use super::keys::{Keys, Kind};
use super::value::Value;

const LIGHT: Kind = Kind {
    name: "a light",
    keys: &["position", "color", "diffuse", "specular", "name"],
};

/// Reads a light: one color, or two.
pub(super) fn light(value: &Value<'_>) -> Result<Light, LoadError> {
    let keys = Keys::of(value, "a table")?;
    keys.only(LIGHT)?;
    let position = keys.need("position", LIGHT.name)?.vector()?;
    let parts = (keys.get("diffuse"), keys.get("specular"));
    match (keys.get("color"), parts) {
        (Some(color), (None, None)) => Ok(Light::point(position, color.color()?)),
        (Some(color), _) => Err(color
            .error("excludes `diffuse` and `specular`")
            .help("keep `color` for both, or the other two")),
        (None, (None, None)) => Err(keys
            .missing("color", LIGHT.name)
            .help("add `color = [1.0, 1.0, 1.0]`, or both `diffuse` and `specular`")),
        (None, _) => Ok(Light {
            position,
            diffuse: keys.need("diffuse", "a light with `specular`")?.color()?,
            specular: keys.need("specular", "a light with `diffuse`")?.color()?,
        }),
    }
}
