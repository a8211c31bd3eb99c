use whitted::Shape;

use crate::scene_file::error::LoadError;
use crate::scene_file::schema::TableSchema;
use crate::scene_file::shape_reader::ShapeReader;
use crate::scene_file::table::Table;

pub(super) const READER: ShapeReader = ShapeReader {
    type_name: "cylinder",
    schema: TableSchema {
        name: "a cylinder",
        keys: &["origin", "radius", "y"],
    },
    position_key: "origin",
    read,
};

fn read(table: &Table<'_>) -> Result<Shape, LoadError> {
    Ok(Shape::Cylinder {
        origin: table.need("origin")?.vector()?,
        radius: table.need("radius")?.number()?,
        y: table.get("y").map(|y| y.interval()).transpose()?,
    })
}
