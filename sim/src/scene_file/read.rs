use whitted::scene::Transfer;
use whitted::{Background, Camera, Color, Real, Scene};

use super::animation::animation;
use super::comment::comment;
use super::counts::check_counts;
use super::error::LoadError;
use super::file::SceneFile;
use super::light::light;
use super::material::{MaterialNames, material, specular_model};
use super::name::check_unique;
use super::object::object;
use super::outline::Outline;
use super::schema::{BACKGROUND, CAMERA};
use super::source::Source;
use super::syntax;
use super::table::Table;
use super::target::targets;
use super::value::Value;

/// Largest value of `Scene::max_depth`, the number of secondary generations of rays.
const MAX_DEPTH: u8 = 32;

/// Reads a whole scene file.
pub(super) fn scene_file(source: &Source<'_>) -> Result<SceneFile, LoadError> {
    let toml = syntax::parse(source)?;
    let table = Table::root(source, toml.get_ref())?;
    check_counts(&table)?;
    let title = table.get("title");
    let title = title.map(|value| value.text("a string")).transpose()?;
    let settings = settings(&table)?;
    let lights = each(&table, "lights", light)?;
    let materials = materials(&table)?;
    let names = MaterialNames(materials.iter().map(|(name, _)| *name).collect());
    let materials = materials
        .iter()
        .map(|(_, value)| material(value))
        .collect::<Result<_, _>>()?;
    let objects = each(&table, "objects", |value| object(value, &names))?;
    check_unique(objects.iter().map(|object| &object.name))?;
    check_unique(lights.iter().map(|light| &light.name))?;
    let targets = targets(&objects, &lights);
    let animation = table
        .get("animation")
        .map(|value| animation(&value, &targets))
        .transpose()?;
    let file = SceneFile {
        title: title.map(str::to_owned),
        comment: comment(source.text),
        settings,
        lights: lights.into_iter().map(|it| it.light).collect(),
        materials,
        material_names: names.0.into_iter().map(str::to_owned).collect(),
        objects: objects.into_iter().map(|it| it.object).collect(),
        animation,
        outline: Outline::new(source, toml.get_ref()),
    };
    file.check_animation()?;
    Ok(file)
}

/// Returns the names and tables of the materials, in the file's order.
fn materials<'a>(table: &Table<'a>) -> Result<Vec<(&'a str, Value<'a>)>, LoadError> {
    let Some(value) = table.get("materials") else {
        return Ok(Vec::new());
    };
    let materials = Table::open_any(&value, "a table of named tables", "`materials`")
        .map_err(|error| error.help("write for example `[materials.glass]`"))?;
    Ok(materials.entries())
}

/// Reads the camera and all top-level keys whose values are not lists.
fn settings(table: &Table<'_>) -> Result<Scene<'static>, LoadError> {
    let camera = table.need("camera").and_then(|value| camera(&value))?;
    let mut scene = Scene::new(camera);
    if let Some(value) = table.get("max_depth") {
        scene.max_depth = value.integer(MAX_DEPTH)?;
    }
    if let Some(value) = table.get("min_weight") {
        scene.min_weight = value.number()?;
    }
    if let Some(value) = table.get("shading") {
        scene.shading = specular_model(&value)?;
    }
    if let Some(value) = table.get("ambient") {
        scene.ambient = value.color()?;
    }
    if let Some(value) = table.get("background") {
        scene.background = background(&value)?;
    }
    if let Some(value) = table.get("transfer") {
        let choices = [("linear", Transfer::Linear), ("srgb", Transfer::Srgb)];
        scene.transfer = value.choice(
            &choices,
            "a transfer function",
            "the transfer functions are",
        )?;
    }
    Ok(scene)
}

fn camera(value: &Value<'_>) -> Result<Camera, LoadError> {
    let table = Table::open(value, CAMERA)?;
    let mut camera = Camera::new(
        table.need("eye")?.vector()?,
        table.need("look_at")?.vector()?,
        table.need("fovy_deg")?.number()?,
    );
    if let Some(up) = table.get("up") {
        camera.up = up.vector()?;
    }
    Ok(camera)
}

fn background(value: &Value<'_>) -> Result<Background, LoadError> {
    let node = value.node.get_ref();
    if node.is_array() || node.is_str() {
        return value.color().map(Background::Solid);
    }
    let expected = "a color or { horizon = COLOR, zenith = COLOR }";
    let table = Table::open_any(value, expected, BACKGROUND.name)?;
    table.reject_unknown(BACKGROUND.name, BACKGROUND.keys)?;
    let color = |key| -> Result<Color<Real>, LoadError> { table.need(key)?.color() };
    Ok(Background::Gradient {
        horizon: color("horizon")?,
        zenith: color("zenith")?,
    })
}

/// Reads an array of tables. If the key is missing, the array is empty.
fn each<'a, T>(
    table: &Table<'a>,
    key: &'static str,
    read: impl Fn(&Value<'a>) -> Result<T, LoadError>,
) -> Result<Vec<T>, LoadError> {
    let Some(value) = table.get(key) else {
        return Ok(Vec::new());
    };
    let values = value.list("an array of tables in double brackets")?;
    values.iter().map(read).collect()
}
