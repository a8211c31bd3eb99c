use whitted::{Background, Camera, Color, Real, Scene};

use super::animation::animation;
use super::error::LoadError;
use super::file::SceneFile;
use super::keys::{Keys, Kind, SCENE};
use super::light::light;
use super::material::{Names, material, shading};
use super::name::{name, only_once};
use super::object::object;
use super::outline::Outline;
use super::source::Source;
use super::target::targets;
use super::value::Value;

/// The generations that `Scene::max_depth` may ask for.
const MOST_DEPTH: u8 = 32;

const CAMERA: Kind = Kind {
    name: "the camera",
    keys: &["eye", "look_at", "up", "fovy_deg"],
};

const BACKGROUND: Kind = Kind {
    name: "the background",
    keys: &["horizon", "zenith"],
};

/// Reads a whole scene file.
pub(super) fn scene_file(source: &Source<'_>) -> Result<SceneFile, LoadError> {
    let table = source.table()?;
    let file = Keys {
        source,
        path: String::new(),
        place: 0..0,
        table: table.get_ref(),
    };
    file.only(SCENE)?;
    let title = file
        .get("title")
        .map(|value| value.text("a string"))
        .transpose()?;
    let settings = settings(&file)?;
    let lights = each(&file, "lights", light)?;
    let named = match file.get("materials") {
        Some(value) => named_tables(&value)?,
        None => Vec::new(),
    };
    let names = Names(named.iter().map(|(name, _)| *name).collect());
    let materials = named
        .iter()
        .map(|(_, value)| material(value))
        .collect::<Result<_, _>>()?;
    let objects = each(&file, "objects", |value| object(value, &names))?;
    let object_names = each(&file, "objects", name)?;
    let light_names = each(&file, "lights", name)?;
    only_once(&object_names)?;
    only_once(&light_names)?;
    let animation = file.get("animation").map(|value| {
        let targets = targets(&objects, &object_names, &light_names);
        animation(&value, &targets)
    });
    let file = SceneFile {
        title: title.map(str::to_owned),
        settings,
        lights,
        materials,
        material_names: names.0.into_iter().map(str::to_owned).collect(),
        objects,
        animation: animation.transpose()?,
        outline: Outline::new(source, table.get_ref()),
    };
    file.check_animation()?;
    Ok(file)
}

fn named_tables<'a>(value: &Value<'a>) -> Result<Vec<(&'a str, Value<'a>)>, LoadError> {
    let keys = Keys::of(value, "a table of named tables")
        .map_err(|error| error.help("write for example `[materials.glass]`"))?;
    Ok(keys.entries())
}

fn settings(file: &Keys<'_>) -> Result<Scene<'static>, LoadError> {
    let camera = file
        .need("camera", SCENE.name)
        .and_then(|value| camera(&value))?;
    let mut scene = Scene::new(camera);
    if let Some(value) = file.get("max_depth") {
        scene.max_depth = value.count(MOST_DEPTH)?;
    }
    if let Some(value) = file.get("min_weight") {
        scene.min_weight = value.number()?;
    }
    if let Some(value) = file.get("shading") {
        scene.shading = shading(&value)?;
    }
    if let Some(value) = file.get("ambient") {
        scene.ambient = value.color()?;
    }
    if let Some(value) = file.get("background") {
        scene.background = background(&value)?;
    }
    Ok(scene)
}

fn camera(value: &Value<'_>) -> Result<Camera, LoadError> {
    let keys = Keys::of(value, "a table")?;
    keys.only(CAMERA)?;
    let need = |key| keys.need(key, CAMERA.name);
    let mut camera = Camera::new(
        need("eye")?.vector()?,
        need("look_at")?.vector()?,
        need("fovy_deg")?.number()?,
    );
    if let Some(up) = keys.get("up") {
        camera.up = up.vector()?;
    }
    Ok(camera)
}

fn background(value: &Value<'_>) -> Result<Background, LoadError> {
    if value.node.get_ref().is_array() {
        return value.color().map(Background::Solid);
    }
    let keys = Keys::of(
        value,
        "a color or { horizon = [r, g, b], zenith = [r, g, b] }",
    )?;
    keys.only(BACKGROUND)?;
    let need = |key| -> Result<Color<Real>, LoadError> { keys.need(key, BACKGROUND.name)?.color() };
    Ok(Background::Gradient {
        horizon: need("horizon")?,
        zenith: need("zenith")?,
    })
}

fn each<'a, T>(
    file: &Keys<'a>,
    key: &'static str,
    read: impl Fn(&Value<'a>) -> Result<T, LoadError>,
) -> Result<Vec<T>, LoadError> {
    let Some(value) = file.get(key) else {
        return Ok(Vec::new());
    };
    let values = value.list("a list of tables with double brackets")?;
    values.iter().map(read).collect()
}
