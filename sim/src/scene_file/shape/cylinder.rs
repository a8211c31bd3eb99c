use whitted::Shape;

use super::Form;
use crate::scene_file::error::LoadError;
use crate::scene_file::keys::{Keys, Kind};

pub(super) const FORM: Form = Form {
    name: "cylinder",
    kind: Kind {
        name: "a cylinder",
        keys: &[
            "type", "origin", "radius", "y", "material", "checker", "name",
        ],
    },
    read,
};

fn read(keys: &Keys<'_>) -> Result<Shape, LoadError> {
    let need = |key| keys.need(key, FORM.kind.name);
    Ok(Shape::Cylinder {
        origin: need("origin")?.vector()?,
        radius: need("radius")?.number()?,
        y: keys.get("y").map(|y| y.interval()).transpose()?,
    })
}
