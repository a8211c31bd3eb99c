use super::error::LoadError;
use super::table::Table;
use super::value::Value;
use crate::text::excerpt;

/// Reads the `name` of an object or a light. Animation tracks refer to objects and lights by name.
pub(super) fn name<'a>(table: &Table<'a>) -> Result<Option<Value<'a>>, LoadError> {
    let name = table.get("name");
    if let Some(name) = &name
        && name.text("a string")?.trim().is_empty()
    {
        return Err(name.error_with_example("must not be empty"));
    }
    Ok(name)
}

/// Checks that all names differ.
pub(super) fn check_unique<'n, 'a: 'n>(
    names: impl Iterator<Item = &'n Option<Value<'a>>>,
) -> Result<(), LoadError> {
    let mut seen = Vec::new();
    for name in names.flatten() {
        let text = name.text("a string")?;
        if seen.contains(&text) {
            return Err(name
                .error(format!("the name `{}` is already taken", excerpt(text)))
                .help("rename one of the two"));
        }
        seen.push(text);
    }
    Ok(())
}
