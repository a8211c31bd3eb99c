use whitted::Object;

use super::error::LoadError;
use super::keys::{Keys, Kind};
use super::material::Names;
use super::nearest::list;
use super::shape::{PLANNED, SHAPES};
use super::texture::texture;
use super::value::Value;

/// All keys of any object, for one that names no type.
const OBJECT: Kind = Kind {
    name: "an object",
    keys: &[
        "type", "material", "checker", "center", "radius", "normal", "point", "bounds", "origin",
        "height", "radii", "y", "depth", "ratio", "frame",
    ],
};

/// Reads an object.
pub(super) fn object(value: &Value<'_>, names: &Names<'_>) -> Result<Object, LoadError> {
    let keys = Keys::of(value, "a table")?;
    let Some(kind) = keys.get("type") else {
        keys.only(OBJECT)?;
        return Err(keys.missing("type", OBJECT.name));
    };
    let what = "a type of object";
    let name = kind.text(what)?;
    if PLANNED.contains(&name) {
        return Err(kind
            .error(format!("`{name}` is not supported yet"))
            .help(format!(
                "the types are {}",
                list(SHAPES.map(|(name, _)| name))
            )));
    }
    let form = kind.choice(&SHAPES, what, "the types are")?;
    keys.only(form.kind)?;
    Ok(Object {
        shape: (form.read)(&keys)?,
        texture: texture(&keys, form.kind, names)?,
    })
}
