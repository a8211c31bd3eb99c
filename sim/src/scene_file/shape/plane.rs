use whitted::Shape;
use whitted::scene::ClipBox;

use crate::scene_file::error::LoadError;
use crate::scene_file::schema::{BOUNDS, TableSchema};
use crate::scene_file::shape_reader::ShapeReader;
use crate::scene_file::table::Table;

pub(super) const READER: ShapeReader = ShapeReader {
    type_name: "plane",
    schema: TableSchema {
        name: "a plane",
        keys: &["normal", "point", "bounds"],
    },
    position_key: "point",
    read,
};

fn read(table: &Table<'_>) -> Result<Shape, LoadError> {
    Ok(Shape::Plane {
        normal: table.need("normal")?.vector()?,
        point: table.need("point")?.vector()?,
        bounds: bounds(table)?,
    })
}

/// Reads the clip box of a plane. If the file gives no interval for an axis, the box is unbounded
/// along that axis.
fn bounds(table: &Table<'_>) -> Result<ClipBox, LoadError> {
    let Some(value) = table.get("bounds") else {
        return Ok(ClipBox::NONE);
    };
    let table = Table::open_any(&value, "a table of intervals", BOUNDS.name)?;
    table.reject_unknown(BOUNDS.name, BOUNDS.keys)?;
    let interval = |key| table.get(key).map(|value| value.interval()).transpose();
    Ok(ClipBox {
        x: interval("x")?,
        y: interval("y")?,
        z: interval("z")?,
    })
}
