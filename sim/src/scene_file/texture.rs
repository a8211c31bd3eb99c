use whitted::scene::Axis;
use whitted::{MaterialId, Texture};

use super::error::LoadError;
use super::material::MaterialNames;
use super::schema::CHECKER;
use super::table::Table;
use super::value::Value;

const AXES: [(&str, [Axis; 2]); 6] = [
    ("xz", [Axis::X, Axis::Z]),
    ("xy", [Axis::X, Axis::Y]),
    ("yz", [Axis::Y, Axis::Z]),
    ("zx", [Axis::Z, Axis::X]),
    ("yx", [Axis::Y, Axis::X]),
    ("zy", [Axis::Z, Axis::Y]),
];

/// Reads the texture of an object, which is one material or a checkerboard. `owner` is the type of
/// the object, as error messages print it.
pub(super) fn texture(
    table: &Table<'_>,
    owner: &str,
    materials: &MaterialNames<'_>,
) -> Result<Texture, LoadError> {
    match (table.get("material"), table.get("checker")) {
        (Some(name), None) => materials.find(&name).map(Texture::Uniform),
        (None, Some(value)) => checker(&value, materials),
        (Some(_), Some(value)) => Err(value
            .error("cannot be combined with `material`")
            .help("keep one of the two")),
        (None, None) => Err(table
            .missing("material", owner)
            .help("add `material = \"..\"` or `checker = { .. }`")),
    }
}

fn checker(value: &Value<'_>, materials: &MaterialNames<'_>) -> Result<Texture, LoadError> {
    let table = Table::open(value, CHECKER)?;
    let [even, odd] = table.need("materials")?.array("two names of materials")?;
    Ok(Texture::Checker {
        size: table.need("size")?.number()?,
        axes: table
            .need("axes")?
            .choice(&AXES, "a pair of axes", "the pairs are")?,
        materials: [materials.find(&even)?, materials.find(&odd)?],
    })
}

/// Returns the materials of a texture.
pub(super) fn materials_of(texture: &Texture) -> [MaterialId; 2] {
    match *texture {
        Texture::Uniform(material) => [material; 2],
        Texture::Checker { materials, .. } => materials,
    }
}
