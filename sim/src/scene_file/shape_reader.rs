use whitted::Shape;

use super::error::LoadError;
use super::schema::TableSchema;
use super::table::Table;

/// Reader of one type of object.
#[derive(Clone, Copy)]
pub(super) struct ShapeReader {
    /// Value of the key `type`.
    pub(super) type_name: &'static str,
    /// Keys of this type, in addition to those of every object.
    pub(super) schema: TableSchema,
    /// Key of the position, which animation tracks can move.
    pub(super) position_key: &'static str,
    /// Reads the shape from a table without unknown keys.
    pub(super) read: fn(&Table<'_>) -> Result<Shape, LoadError>,
}

impl ShapeReader {
    /// Returns true if the type has a `radius`, which animation tracks can change.
    pub(super) fn has_radius(&self) -> bool {
        self.schema.keys.contains(&"radius")
    }
}
