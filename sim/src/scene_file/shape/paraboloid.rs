use whitted::Shape;

use super::Form;
use crate::scene_file::error::LoadError;
use crate::scene_file::keys::{Keys, Kind};

pub(super) const FORM: Form = Form {
    name: "paraboloid",
    kind: Kind {
        name: "a paraboloid",
        keys: &["type", "origin", "y", "material", "checker", "name"],
    },
    read,
};

fn read(keys: &Keys<'_>) -> Result<Shape, LoadError> {
    let need = |key| keys.need(key, FORM.kind.name);
    Ok(Shape::Paraboloid {
        origin: need("origin")?.vector()?,
        y: need("y")?.interval()?,
    })
}
