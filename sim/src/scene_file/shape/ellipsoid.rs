use whitted::Shape;

use crate::scene_file::error::LoadError;
use crate::scene_file::schema::TableSchema;
use crate::scene_file::shape_reader::ShapeReader;
use crate::scene_file::table::Table;

pub(super) const READER: ShapeReader = ShapeReader {
    type_name: "ellipsoid",
    schema: TableSchema {
        name: "an ellipsoid",
        keys: &["center", "radii"],
    },
    position_key: "center",
    read,
};

fn read(table: &Table<'_>) -> Result<Shape, LoadError> {
    Ok(Shape::Ellipsoid {
        center: table.need("center")?.vector()?,
        radii: table.need("radii")?.vector()?,
    })
}
