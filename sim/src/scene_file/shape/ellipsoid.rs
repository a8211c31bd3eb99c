use whitted::Shape;

use super::Form;
use crate::scene_file::error::LoadError;
use crate::scene_file::keys::{Keys, Kind};

pub(super) const FORM: Form = Form {
    name: "ellipsoid",
    kind: Kind {
        name: "an ellipsoid",
        keys: &["type", "center", "radii", "material", "checker", "name"],
    },
    read,
};

fn read(keys: &Keys<'_>) -> Result<Shape, LoadError> {
    let need = |key| keys.need(key, FORM.kind.name);
    Ok(Shape::Ellipsoid {
        center: need("center")?.vector()?,
        radii: need("radii")?.vector()?,
    })
}
