use super::error::LoadError;
use super::keys::Keys;
use super::value::Value;

/// What a table calls itself, so that tracks can name it.
pub(super) fn name<'a>(table: &Value<'a>) -> Result<Option<Value<'a>>, LoadError> {
    let name = Keys::of(table, "a table")?.get("name");
    if let Some(name) = &name {
        let text = name.text("a string")?;
        if text.trim().is_empty() {
            return Err(name
                .error("must not be empty")
                .help("write for example `name = \"ball\"`"));
        }
    }
    Ok(name)
}

/// No two may be called the same.
pub(super) fn only_once(names: &[Option<Value<'_>>]) -> Result<(), LoadError> {
    let mut seen = Vec::new();
    for name in names.iter().flatten() {
        let text = name.text("a string")?;
        if seen.contains(&text) {
            return Err(name
                .error(format!("there is another `{text}`"))
                .help("rename one of the two"));
        }
        seen.push(text);
    }
    Ok(())
}
