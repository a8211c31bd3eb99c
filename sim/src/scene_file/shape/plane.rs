use whitted::Shape;
use whitted::scene::ClipBox;

use super::Form;
use crate::scene_file::error::LoadError;
use crate::scene_file::keys::{Keys, Kind};

pub(super) const FORM: Form = Form {
    name: "plane",
    kind: Kind {
        name: "a plane",
        keys: &[
            "type", "normal", "point", "bounds", "material", "checker", "name",
        ],
    },
    read,
};

fn read(keys: &Keys<'_>) -> Result<Shape, LoadError> {
    let need = |key| keys.need(key, FORM.kind.name);
    Ok(Shape::Plane {
        normal: need("normal")?.vector()?,
        point: need("point")?.vector()?,
        bounds: bounds(keys)?,
    })
}

const BOUNDS: Kind = Kind {
    name: "`bounds`",
    keys: &["x", "y", "z"],
};

fn bounds(keys: &Keys<'_>) -> Result<ClipBox, LoadError> {
    let Some(value) = keys.get("bounds") else {
        return Ok(ClipBox::NONE);
    };
    let keys = Keys::of(&value, "a table of intervals")?;
    keys.only(BOUNDS)?;
    let interval = |key| keys.get(key).map(|value| value.interval()).transpose();
    Ok(ClipBox {
        x: interval("x")?,
        y: interval("y")?,
        z: interval("z")?,
    })
}
