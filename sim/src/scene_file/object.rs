use whitted::Object;

use super::error::LoadError;
use super::keys::{Keys, Kind};
use super::material::Names;
use super::shape::SHAPES;
use super::texture::texture;
use super::value::Value;

/// All keys of any object, for one that names no type.
const OBJECT: Kind = Kind {
    name: "an object",
    keys: &[
        "type", "material", "checker", "center", "radius", "radii", "origin", "height", "y",
        "normal", "point", "bounds", "depth", "ratio", "frame", "name",
    ],
};

/// Reads an object.
pub(super) fn object(value: &Value<'_>, names: &Names<'_>) -> Result<Object, LoadError> {
    let keys = Keys::of(value, "a table")?;
    let Some(kind) = keys.get("type") else {
        keys.only(OBJECT)?;
        return Err(keys.missing("type", OBJECT.name));
    };
    let forms = SHAPES.map(|form| (form.name, form));
    let form = kind.choice(&forms, "a type of object", "the types are")?;
    keys.only(form.kind)?;
    Ok(Object {
        shape: (form.read)(&keys)?,
        texture: texture(&keys, form.kind, names)?,
    })
}
