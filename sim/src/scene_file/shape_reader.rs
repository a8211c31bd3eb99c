use whitted::Shape;

use super::error::LoadError;
use super::schema::TableSchema;
use super::table::Table;

/// Reads one type of object from a scene file.
#[derive(Clone, Copy)]
pub(super) struct ShapeReader {
    /// Value of the key `type` for this type of object.
    pub(super) type_name: &'static str,
    /// Keys that this type of object accepts in addition to the keys of every object.
    pub(super) schema: TableSchema,
    /// Key that sets the object's position. Animation tracks can change the position.
    pub(super) position_key: &'static str,
    /// Reads the shape from a table whose keys are already checked.
    pub(super) read: fn(&Table<'_>) -> Result<Shape, LoadError>,
}

impl ShapeReader {
    /// Returns true if objects of this type have a `radius`. Animation tracks can change the
    /// radius.
    pub(super) fn has_radius(&self) -> bool {
        self.schema.keys.contains(&"radius")
    }
}
