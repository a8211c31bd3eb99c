use whitted::Texture;
use whitted::scene::Axis;

use super::error::LoadError;
use super::keys::{Keys, Kind};
use super::material::Names;
use super::value::Value;

const CHECKER: Kind = Kind {
    name: "`checker`",
    keys: &["size", "axes", "materials"],
};

const AXES: [(&str, [Axis; 2]); 6] = [
    ("xz", [Axis::X, Axis::Z]),
    ("xy", [Axis::X, Axis::Y]),
    ("yz", [Axis::Y, Axis::Z]),
    ("zx", [Axis::Z, Axis::X]),
    ("yx", [Axis::Y, Axis::X]),
    ("zy", [Axis::Z, Axis::Y]),
];

/// Reads what covers an object of a kind: one material, or a checkerboard.
pub(super) fn texture(
    keys: &Keys<'_>,
    kind: Kind,
    names: &Names<'_>,
) -> Result<Texture, LoadError> {
    match (keys.get("material"), keys.get("checker")) {
        (Some(name), None) => names.find(&name).map(Texture::Uniform),
        (None, Some(value)) => checker(&value, names),
        (Some(_), Some(value)) => Err(value
            .error("excludes `material`")
            .help("keep one of the two")),
        (None, None) => Err(keys
            .missing("material", kind.name)
            .help("add `material = \"..\"` or `checker = { .. }`")),
    }
}

fn checker(value: &Value<'_>, names: &Names<'_>) -> Result<Texture, LoadError> {
    let keys = Keys::of(value, "a table")?;
    keys.only(CHECKER)?;
    let need = |key| keys.need(key, CHECKER.name);
    let [even, odd] = need("materials")?.array("two names of materials")?;
    Ok(Texture::Checker {
        size: need("size")?.number()?,
        axes: need("axes")?.choice(&AXES, "a pair of axes", "the pairs are")?,
        materials: [names.find(&even)?, names.find(&odd)?],
    })
}
