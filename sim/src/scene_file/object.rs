use whitted::Object;

use super::error::LoadError;
use super::material::MaterialNames;
use super::name::name;
use super::schema::OBJECT;
use super::shape::SHAPES;
use super::shape_reader::ShapeReader;
use super::table::Table;
use super::texture::texture;
use super::value::Value;

/// An object, its type, and its name.
pub(super) struct NamedObject<'a> {
    pub(super) object: Object,
    pub(super) shape: ShapeReader,
    pub(super) name: Option<Value<'a>>,
}

/// Reads an object of any type from a scene file.
pub(super) fn object<'a>(
    value: &Value<'a>,
    materials: &MaterialNames<'_>,
) -> Result<NamedObject<'a>, LoadError> {
    let table = Table::open_any(value, "a table", OBJECT.name)?;
    let Some(kind) = table.get("type") else {
        table.reject_unknown(OBJECT.name, &all_keys())?;
        return Err(table.missing("type", OBJECT.name));
    };
    let shapes = SHAPES.map(|shape| (shape.type_name, shape));
    let shape = kind.choice(&shapes, "a type of object", "the types are")?;
    let keys = [OBJECT.keys, shape.schema.keys].concat();
    table.reject_unknown(shape.schema.name, &keys)?;
    let table = table.named(shape.schema.name);
    let object = Object {
        shape: (shape.read)(&table)?,
        texture: texture(&table, shape.schema.name, materials)?,
    };
    let name = name(&table)?;
    Ok(NamedObject {
        object,
        shape,
        name,
    })
}

/// Returns all keys that at least one type of object accepts. An object whose `type` is missing may
/// have any of these keys.
fn all_keys() -> Vec<&'static str> {
    let mut keys = OBJECT.keys.to_vec();
    for key in SHAPES.iter().flat_map(|shape| shape.schema.keys) {
        if !keys.contains(key) {
            keys.push(key);
        }
    }
    keys
}
