mod motion;

use whitted::scene::{SceneItem, SceneProblem};
use whitted::{Real, SceneError};

use super::error::LoadError;
use super::example::example;
use super::file::SceneFile;
use super::outline::Entry;

impl SceneFile {
    /// Leads an error in a scene's value back to the line that it stands on.
    pub fn explain(&self, error: SceneError) -> LoadError {
        let item = self.path(error.item);
        let entry = self.entry(&item, error.field);
        let key = match entry {
            Some(entry) => entry.path.clone(),
            None => child(&item, error.field),
        };
        // A key that is left to its default has no line, but its table has.
        let line = entry.or_else(|| self.outline.find(&item));
        LoadError {
            file: self.outline.name().to_owned(),
            line: line.map(|entry| entry.line),
            reason: reason(error.problem, entry),
            help: help(error.problem, &key),
            key: Some(key),
        }
    }

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

    /// A field's key, or the one that stands for it.
    fn entry(&self, item: &str, field: &str) -> Option<&Entry> {
        let stand_in = match field {
            "diffuse" | "specular" => "color",
            field => field,
        };
        [field, stand_in]
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
        (SceneProblem::OutOfRange { .. }, Some(entry)) => format!("{problem}, not {}", entry.text),
        _ => problem.to_string(),
    }
}

fn help(problem: SceneProblem, key: &str) -> Option<String> {
    let name = key.rsplit('.').next().unwrap_or_default();
    // An array's element is shown in its array.
    let name = name.split('[').next().unwrap_or_default();
    let example = example(name);
    Some(match problem {
        SceneProblem::NoView => "move one of the two".to_owned(),
        SceneProblem::AlongView => "give another `up`, or move `eye` or `look_at`".to_owned(),
        SceneProblem::EmptyInterval => "write the lower end first: [low, high]".to_owned(),
        SceneProblem::TooMany { .. } => "leave some out".to_owned(),
        _ if example.is_empty() => return None,
        SceneProblem::OutOfRange { least, most } => match nearest(example, least, most) {
            Some(end) => format!("write for example `{name} = {end}`"),
            None => format!("write for example `{example}`"),
        },
        _ => format!("write for example `{example}`"),
    })
}

/// Of a range that the example's number is outside of, which may be that of a
/// scene of unusual size: the end that is nearest to it.
fn nearest(example: &str, least: Real, most: Real) -> Option<Real> {
    let number: Real = example.rsplit(' ').next()?.parse().ok()?;
    let nearest = number.clamp(least, most);
    (nearest != number).then_some(nearest)
}
