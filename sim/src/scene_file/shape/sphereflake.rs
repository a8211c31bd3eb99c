use whitted::{Real, Shape, Vec3};

use super::Form;
use crate::scene_file::error::LoadError;
use crate::scene_file::keys::{Keys, Kind};
use crate::scene_file::value::Value;

/// The generations that `Shape::Sphereflake` may have.
const MOST_DEPTH: u8 = 8;

pub(super) const FORM: Form = Form {
    name: "sphereflake",
    kind: Kind {
        name: "a sphereflake",
        keys: &[
            "type", "center", "radius", "depth", "ratio", "frame", "material", "checker", "name",
        ],
    },
    read,
};

fn read(keys: &Keys<'_>) -> Result<Shape, LoadError> {
    let need = |key| keys.need(key, FORM.kind.name);
    Ok(Shape::Sphereflake {
        center: need("center")?.vector()?,
        radius: need("radius")?.number()?,
        depth: need("depth")?.count(MOST_DEPTH)?,
        ratio: match keys.get("ratio") {
            Some(ratio) => ratio.number()?,
            None => Shape::FLAKE_RATIO,
        },
        frame: match keys.get("frame") {
            Some(rows) => frame(&rows)?,
            None => Shape::FLAKE_FRAME,
        },
    })
}

/// That the rows are orthonormal is checked where a scene is prepared.
fn frame(rows: &Value<'_>) -> Result<[Vec3<Real>; 3], LoadError> {
    let [u, v, w] = rows.array("three rows [u, v, w]")?;
    Ok([u.vector()?, v.vector()?, w.vector()?])
}
