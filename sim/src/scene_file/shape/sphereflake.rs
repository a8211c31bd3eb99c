use whitted::{Real, Shape, Vec3};

use crate::scene_file::error::LoadError;
use crate::scene_file::schema::TableSchema;
use crate::scene_file::shape_reader::ShapeReader;
use crate::scene_file::table::Table;
use crate::scene_file::value::Value;

/// Largest number of generations of spheres that `Shape::Sphereflake` supports.
const MAX_DEPTH: u8 = 8;

pub(super) const READER: ShapeReader = ShapeReader {
    type_name: "sphereflake",
    schema: TableSchema {
        name: "a sphereflake",
        keys: &["center", "radius", "depth", "ratio", "frame"],
    },
    position_key: "center",
    read,
};

fn read(table: &Table<'_>) -> Result<Shape, LoadError> {
    Ok(Shape::Sphereflake {
        center: table.need("center")?.vector()?,
        radius: table.need("radius")?.number()?,
        depth: table.need("depth")?.integer(MAX_DEPTH)?,
        ratio: match table.get("ratio") {
            Some(ratio) => ratio.number()?,
            None => Shape::FLAKE_RATIO,
        },
        frame: match table.get("frame") {
            Some(rows) => frame(&rows)?,
            None => Shape::FLAKE_FRAME,
        },
    })
}

/// Reads the basis of a sphereflake. The library checks later, when it prepares the scene, that the
/// rows are orthonormal.
fn frame(rows: &Value<'_>) -> Result<[Vec3<Real>; 3], LoadError> {
    let [u, v, w] = rows.array("three rows [u, v, w]")?;
    Ok([u.vector()?, v.vector()?, w.vector()?])
}
