use whitted::Shape;

use crate::scene_file::error::LoadError;
use crate::scene_file::schema::TableSchema;
use crate::scene_file::shape_reader::ShapeReader;
use crate::scene_file::table::Table;

pub(super) const READER: ShapeReader = ShapeReader {
    type_name: "paraboloid",
    schema: TableSchema {
        name: "a paraboloid",
        keys: &["origin", "y"],
    },
    position_key: "origin",
    read,
};

fn read(table: &Table<'_>) -> Result<Shape, LoadError> {
    Ok(Shape::Paraboloid {
        origin: table.need("origin")?.vector()?,
        y: table.need("y")?.interval()?,
    })
}
