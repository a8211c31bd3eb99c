use toml::de::DeValue;

use super::error::LoadError;
use super::file::{MAX_LIGHTS, MAX_MATERIALS, MAX_OBJECTS};
use super::table::Table;

/// Returns an error if a scene has too many objects, lights or materials. This check comes before
/// the lists are read, so that the error for a long file takes little time.
pub(super) fn check_counts(table: &Table<'_>) -> Result<(), LoadError> {
    let lists = [
        ("objects", MAX_OBJECTS),
        ("lights", MAX_LIGHTS),
        ("materials", MAX_MATERIALS),
    ];
    for (list, max) in lists {
        let Some(value) = table.get(list) else {
            continue;
        };
        let count = match value.node.get_ref() {
            DeValue::Array(nodes) => nodes.len(),
            DeValue::Table(table) => table.len(),
            _ => continue,
        };
        if count > max {
            let reason = format!("must be at most {max}, not {count}");
            return Err(value.error(reason).help("remove some of them"));
        }
    }
    Ok(())
}
