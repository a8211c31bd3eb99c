//! Converts an error of the library to an error that names a line and a key of the scene file.

use whitted::scene::{SceneItem, SceneProblem};
use whitted::{Real, SceneError};

use super::error::LoadError;
use super::example::example;
use super::file::SceneFile;
use super::outline::Entry;
use crate::text::excerpt;

impl SceneFile {
    /// Converts an error of the library to an error that names the key of the rejected value and
    /// its line in the scene file.
    pub fn explain(&self, error: SceneError) -> LoadError {
        let item = self.path(error.item);
        let entry = self.entry(&item, error.field);
        let key = match entry {
            Some(entry) => entry.path.clone(),
            None => child(&item, error.field),
        };
        // If the file does not contain the key, the error has the line of the table to which the
        // key belongs.
        let line = entry.or_else(|| self.outline.find(&item));
        LoadError {
            file: self.outline.name().to_owned(),
            line: line.map(|entry| entry.line),
            reason: reason(error.problem, entry),
            help: help(error.problem, &key),
            key: Some(key),
        }
    }

    /// Returns the path of a scene item's table in the file, such as `lights[0]`.
    fn path(&self, item: SceneItem) -> String {
        match item {
            SceneItem::Scene => String::new(),
            SceneItem::Camera => "camera".to_owned(),
            SceneItem::Light(index) => format!("lights[{index}]"),
            SceneItem::Object(index) => format!("objects[{index}]"),
            SceneItem::Material(index) => match self.material_names.get(usize::from(index)) {
                Some(name) => format!("materials.{name}"),
                None => "materials".to_owned(),
            },
        }
    }

    /// Returns the scene-file key that sets a field of the scene. The key `color` of a light may
    /// set both of its fields `diffuse` and `specular`.
    fn entry(&self, item: &str, field: &str) -> Option<&Entry> {
        let alternative = match field {
            "diffuse" | "specular" => "color",
            field => field,
        };
        [field, alternative]
            .into_iter()
            .find_map(|key| self.outline.find(&child(item, key)))
    }
}

fn child(path: &str, key: &str) -> String {
    match path {
        "" => key.to_owned(),
        path => format!("{path}.{key}"),
    }
}

fn reason(problem: SceneProblem, entry: Option<&Entry>) -> String {
    match (problem, entry) {
        (SceneProblem::OutOfRange { .. }, Some(entry)) => {
            format!("{problem}, not {}", excerpt(&entry.text))
        }
        _ => problem.to_string(),
    }
}

fn help(problem: SceneProblem, key: &str) -> Option<String> {
    let name = key.rsplit('.').next().unwrap_or_default();
    // If the rejected value is an element of an array, the example shows the whole array.
    let name = name.split('[').next().unwrap_or_default();
    let example = example(name);
    Some(match problem {
        SceneProblem::NoView => "move `eye` or `look_at`".to_owned(),
        SceneProblem::AlongView => "change `up`, or move `eye` or `look_at`".to_owned(),
        SceneProblem::EmptyInterval => "write the lower end first: [low, high]".to_owned(),
        SceneProblem::TooMany { .. } => "remove some of them".to_owned(),
        _ if example.is_empty() => return None,
        SceneProblem::OutOfRange { least, most } => match clamped(example, least, most) {
            Some(bound) => format!("write for example `{name} = {bound}`"),
            None => format!("write for example `{example}`"),
        },
        _ => format!("write for example `{example}`"),
    })
}

/// Clamps the number in an example line to the range of accepted values. Returns the nearest end of
/// the range if the number is outside, or `None` if the number is inside. The number can be outside
/// because the example is fixed, while the accepted range of a size depends on the scene.
fn clamped(example: &str, least: Real, most: Real) -> Option<Real> {
    let number: Real = example.rsplit(' ').next()?.parse().ok()?;
    let clamped = number.clamp(least, most);
    (clamped != number).then_some(clamped)
}
