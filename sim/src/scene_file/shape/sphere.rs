use whitted::Shape;

use super::Form;
use crate::scene_file::error::LoadError;
use crate::scene_file::keys::{Keys, Kind};

pub(super) const FORM: Form = Form {
    name: "sphere",
    kind: Kind {
        name: "a sphere",
        keys: &["type", "center", "radius", "material", "checker", "name"],
    },
    read,
};

fn read(keys: &Keys<'_>) -> Result<Shape, LoadError> {
    let need = |key| keys.need(key, FORM.kind.name);
    Ok(Shape::Sphere {
        center: need("center")?.vector()?,
        radius: need("radius")?.number()?,
    })
}
