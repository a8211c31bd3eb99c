//! Compares docs/scenes.md with the reader of scene files.

use std::collections::{BTreeMap, BTreeSet};
use std::error::Error;

use whitted::Real;
use whitted::scene::ior;
use whitted_sim::scene_file::{self, Buffer};

type Outcome = Result<(), Box<dyn Error>>;

const PAGE: &str = include_str!("../../docs/scenes.md");

/// Returns the first cell of every table row that begins with code, by the heading above it.
fn rows() -> BTreeMap<String, Vec<(&'static str, &'static str)>> {
    let mut rows: BTreeMap<String, Vec<_>> = BTreeMap::new();
    let mut heading = String::new();
    for line in PAGE.lines() {
        if let Some(text) = line.trim_start_matches('#').strip_prefix(' ')
            && line.starts_with('#')
        {
            heading = text.to_lowercase();
        }
        let mut cells = line.split('|').map(str::trim).skip(1);
        if let (Some(first), Some(second)) = (cells.next(), cells.next())
            && let Some(code) = first.strip_prefix('`').and_then(|it| it.strip_suffix('`'))
        {
            rows.entry(heading.clone())
                .or_default()
                .push((code, second));
        }
    }
    rows
}

/// Returns the heading of a table's section: its name without article and backquotes.
fn heading(table: &str) -> String {
    let name = table.rsplit(' ').next().unwrap_or(table);
    name.trim_matches('`').to_owned()
}

#[test]
fn documents_exactly_the_keys_that_the_reader_accepts() {
    let rows = rows();
    for table in scene_file::tables() {
        let section = heading(table.name);
        let documented = rows.get(&section).into_iter().flatten();
        let documented: BTreeSet<_> = documented
            .map(|(key, _)| *key)
            .filter(|key| !key.starts_with('"'))
            .collect();
        let accepted: BTreeSet<_> = table.keys.iter().copied().collect();
        assert_eq!(
            documented, accepted,
            "section `{section}` of docs/scenes.md"
        );
    }
}

#[test]
fn has_no_section_of_keys_that_the_reader_does_not_know() {
    let known: BTreeSet<_> = scene_file::tables()
        .iter()
        .map(|table| heading(table.name))
        .collect();
    for (section, rows) in rows() {
        // Other sections list values, such as animation targets and types of objects.
        let is_known = known.contains(&section);
        let lists_values = ["open and closed objects", "targets"].contains(&section.as_str());
        assert!(is_known || lists_values, "{section}: {rows:?}");
    }
}

#[test]
fn documents_the_named_media() -> Outcome {
    let rows = rows();
    let media = rows["material"]
        .iter()
        .filter_map(|(name, index)| Some((name.strip_prefix('"')?.strip_suffix('"')?, *index)));
    let mut documented = Vec::new();
    for (name, index) in media {
        let index: Real = index.parse().map_err(|_| format!("{name}: {index}"))?;
        documented.push((name, index));
    }
    assert_eq!(documented, ior::NAMED);
    Ok(())
}

#[test]
fn lists_all_types_of_objects() {
    let rows = rows();
    let listed: BTreeSet<_> = rows["open and closed objects"]
        .iter()
        .map(|(name, _)| (*name).to_owned())
        .collect();
    let common = [
        "scene",
        "camera",
        "background",
        "light",
        "material",
        "object",
    ];
    let nested = ["checker", "bounds", "animation", "track"];
    let types: BTreeSet<_> = scene_file::tables()
        .iter()
        .map(|table| heading(table.name))
        .filter(|name| !common.contains(&name.as_str()) && !nested.contains(&name.as_str()))
        .collect();
    assert_eq!(listed, types);
}

/// Builds a scene with a named object of each type and a named light, and animates every target.
#[test]
fn every_documented_target_can_be_animated() -> Outcome {
    let objects = [
        (
            "center",
            r#"type = "sphere", center = [0, 0, 0], radius = 1"#,
        ),
        (
            "origin",
            r#"type = "cylinder", origin = [0, 0, 0], radius = 1"#,
        ),
        (
            "point",
            r#"type = "plane", normal = [0, 1, 0], point = [0, 0, 0]"#,
        ),
    ];
    for (target, value) in &rows()["targets"] {
        let target = target.trim_matches('"');
        let key = target.rsplit('.').next().unwrap_or_default();
        let object = objects.iter().find(|(position, _)| *position == key);
        let (_, object) = object.unwrap_or(&objects[0]);
        let value = match value.contains("[x") || value.contains("[r") {
            true => "[0, 0, 1]",
            false => "2",
        };
        let scene = format!(
            r#"
            camera = {{ eye = [0, 0, 9], look_at = [0, 0, 0], fovy_deg = 33 }}
            materials = {{ red = {{ kd = [1, 0, 0] }} }}
            lights = [{{ name = "NAME", position = [0, 9, 0], color = [1, 1, 1] }}]
            objects = [{{ name = "NAME", material = "red", {object} }}]
            animation = {{ duration = 1, tracks = [{{ target = "{target}", keys = [[0, {value}]] }}] }}
            "#
        );
        scene_file::parse(target, &scene)?;
    }
    Ok(())
}

#[test]
fn first_example_can_be_prepared() -> Outcome {
    let example = PAGE.split("```toml\n").nth(1);
    let example = example.and_then(|rest| rest.split("```").next());
    let file = scene_file::parse("docs/scenes.md", example.ok_or("no example")?)?;
    file.prepare(&mut Box::new(Buffer::new()))?;
    Ok(())
}
