//! Reads scene files. Panics with a message on invalid files.

use std::fmt::Display;
use std::path::Path;

use toml::{Table, Value};

use crate::keys::{Keys, array, number, numbers, table_of, vector, whole};
use crate::vec3::{Color, Vec3, vec3};
use crate::{
    Axis, Background, Camera, Cover, Float, Light, Material, Model, Object, Scene, Settings, Shape,
    Sphereflake, upright_frame,
};

/// Scene that owns its lists, so that tests can modify it before rendering.
#[derive(Clone, Debug)]
pub struct OwnedScene<F> {
    pub camera: Camera<F>,
    pub settings: Settings<F>,
    pub lights: Vec<Light<F>>,
    pub materials: Vec<Material<F>>,
    pub objects: Vec<Object<F>>,
}

impl<F: Float> OwnedScene<F> {
    /// Returns the scene with borrowed lists.
    pub fn scene(&self) -> Scene<'_, F> {
        Scene {
            camera: self.camera,
            settings: self.settings,
            lights: &self.lights,
            materials: &self.materials,
            objects: &self.objects,
        }
    }
}

/// Reads a scene file.
pub fn load<F: Float>(path: impl AsRef<Path>) -> OwnedScene<F> {
    let path = path.as_ref();
    let name = path.display();
    let text = std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{name}: {error}"));
    read(&text, &name)
}

/// Parses the text of a scene file.
pub fn parse<F: Float>(text: &str) -> OwnedScene<F> {
    read(text, &"scene")
}

fn read<F: Float>(text: &str, name: &dyn Display) -> OwnedScene<F> {
    let table = text
        .parse()
        .unwrap_or_else(|error| panic!("{name}: {error}"));
    let mut file = Keys::new(table, name.to_string());
    file.take("title");
    let model = file.take("shading").map_or(Model::Phong, model);
    let camera = camera(file.table("camera"));
    let mut settings = Settings {
        max_depth: file.take("max_depth").map_or(5, whole),
        min_weight: file
            .take("min_weight")
            .map_or(F::ONE / F::lit(255.0), number),
        ray_budget: u32::MAX,
        epsilon: F::ZERO,
        ambient: file.take("ambient").map_or(Color::ONE, vector),
        background: file
            .take("background")
            .map_or(Background::Solid(Color::ZERO), background),
    };
    let lights = file.tables("lights").map(light).collect();
    let named = file.take("materials").map_or(Table::new(), table_of);
    let names: Vec<String> = named.keys().cloned().collect();
    let materials = named
        .into_iter()
        .map(|(name, value)| material(Keys::new(table_of(value), name), model))
        .collect();
    let objects: Vec<_> = file
        .tables("objects")
        .map(|keys| object(keys, &names))
        .collect();
    file.finish();
    let scale = objects
        .iter()
        .map(|object| extent(&object.shape))
        .fold(max_abs(camera.eye), F::max);
    settings.epsilon = scale * F::lit(16.0) * F::ULP;
    OwnedScene {
        camera,
        settings,
        lights,
        materials,
        objects,
    }
}

fn camera<F: Float>(mut keys: Keys) -> Camera<F> {
    let camera = Camera {
        eye: vector(keys.require("eye")),
        look_at: vector(keys.require("look_at")),
        up: keys
            .take("up")
            .map_or(vec3(F::ZERO, F::ONE, F::ZERO), vector),
        fovy_deg: number(keys.require("fovy_deg")),
    };
    keys.finish();
    camera
}

fn background<F: Float>(value: Value) -> Background<F> {
    if value.is_array() {
        return Background::Solid(vector(value));
    }
    let mut keys = Keys::new(table_of(value), "background".to_owned());
    let gradient = Background::Gradient {
        horizon: vector(keys.require("horizon")),
        zenith: vector(keys.require("zenith")),
    };
    keys.finish();
    gradient
}

fn light<F: Float>(mut keys: Keys) -> Light<F> {
    let position = vector(keys.require("position"));
    let (diffuse, specular) = match keys.take("color") {
        Some(color) => (color.clone(), color),
        None => (keys.require("diffuse"), keys.require("specular")),
    };
    keys.finish();
    Light {
        position,
        diffuse: vector(diffuse),
        specular: vector(specular),
    }
}

fn material<F: Float>(mut keys: Keys, default_model: Model) -> Material<F> {
    let mut color = |key| keys.take(key).map_or(Color::ZERO, vector);
    let [ka, kd, ks, kr, kt, le] = ["ka", "kd", "ks", "kr", "kt", "le"].map(&mut color);
    let (shininess, ior) = (keys.take("shininess"), keys.take("ior"));
    let name = &keys.name;
    assert!(
        ks.is_zero() || shininess.is_some(),
        "{name}: `ks` needs a `shininess`"
    );
    assert!(kt.is_zero() || ior.is_some(), "{name}: `kt` needs an `ior`");
    let model = keys.take("model").map_or(default_model, model);
    keys.finish();
    Material {
        ka,
        kd,
        ks,
        kr,
        kt,
        le,
        shininess: shininess.map_or(F::ONE, number),
        ior: ior.map_or(F::ONE, index_of_refraction),
        model,
    }
}

fn index_of_refraction<F: Float>(value: Value) -> F {
    let Some(name) = value.as_str() else {
        return number(value);
    };
    F::lit(match name {
        "vacuum" => 1.0,
        "air" => 1.000292,
        "plastic" => 1.11,
        "glass" => 1.22,
        "water" => 1.33,
        "alcohol" => 1.362,
        "diamond" => 2.417,
        _ => panic!("unknown medium `{name}`"),
    })
}

fn model(value: Value) -> Model {
    match value.as_str() {
        Some("phong") => Model::Phong,
        Some("blinn-phong") => Model::BlinnPhong,
        _ => panic!("unknown shading model {value:?}"),
    }
}

fn object<F: Float>(mut keys: Keys, names: &[String]) -> Object<F> {
    let shape = match keys.require("type").as_str() {
        Some("sphere") => Shape::Sphere {
            center: vector(keys.require("center")),
            radius: number(keys.require("radius")),
        },
        Some("ellipsoid") => Shape::Ellipsoid {
            center: vector(keys.require("center")),
            radii: vector(keys.require("radii")),
        },
        Some("cylinder") => Shape::Cylinder {
            origin: vector(keys.require("origin")),
            radius: number(keys.require("radius")),
            y: keys.take("y").map(numbers),
        },
        Some("cone") => Shape::Cone {
            origin: vector(keys.require("origin")),
            radius: number(keys.require("radius")),
            height: number(keys.require("height")),
            y: keys.take("y").map(numbers),
        },
        Some("paraboloid") => Shape::Paraboloid {
            origin: vector(keys.require("origin")),
            y: keys.take("y").map(numbers),
        },
        Some("plane") => Shape::Plane {
            normal: vector(keys.require("normal")).unit(),
            point: vector(keys.require("point")),
            bounds: keys.take("bounds").map_or([None; 3], bounds),
        },
        Some("sphereflake") => Shape::Sphereflake(Sphereflake {
            center: vector(keys.require("center")),
            radius: number(keys.require("radius")),
            depth: whole(keys.require("depth")),
            ratio: keys.take("ratio").map_or(F::ONE / F::lit(3.0), number),
            frame: keys
                .take("frame")
                .map_or(upright_frame(), |rows| array(rows).map(|row| vector(row))),
        }),
        other => panic!("unknown object type {other:?}"),
    };
    let cover = match keys.take("checker") {
        Some(value) => checker(value, names),
        None => Cover::Material(material_named(keys.require("material"), names)),
    };
    keys.finish();
    Object { shape, cover }
}

fn bounds<F: Float>(value: Value) -> [Option<[F; 2]>; 3] {
    let mut keys = Keys::new(table_of(value), "bounds".to_owned());
    let bounds = ["x", "y", "z"].map(|axis| keys.take(axis).map(numbers));
    keys.finish();
    bounds
}

fn checker<F: Float>(value: Value, names: &[String]) -> Cover<F> {
    let mut keys = Keys::new(table_of(value), "checker".to_owned());
    let cover = Cover::Checker {
        size: number(keys.require("size")),
        axes: match keys.require("axes").as_str() {
            Some("xy" | "yx") => [Axis::X, Axis::Y],
            Some("yz" | "zy") => [Axis::Y, Axis::Z],
            Some("xz" | "zx") => [Axis::X, Axis::Z],
            other => panic!("expected two different axes, such as \"xz\", found {other:?}"),
        },
        materials: array(keys.require("materials")).map(|name| material_named(name, names)),
    };
    keys.finish();
    cover
}

fn material_named(value: Value, names: &[String]) -> usize {
    names
        .iter()
        .position(|name| value.as_str() == Some(name))
        .unwrap_or_else(|| panic!("unknown material {value:?}"))
}

/// Returns the greatest absolute component.
fn max_abs<F: Float>(v: Vec3<F>) -> F {
    v.x.abs().max(v.y.abs()).max(v.z.abs())
}

/// Returns the approximate distance of a shape's farthest point from the world origin,
/// ignoring unbounded directions. Rounding errors of coordinates scale with it.
fn extent<F: Float>(shape: &Shape<F>) -> F {
    let end = |y: Option<[F; 2]>| y.map_or(F::ZERO, |[low, high]| low.abs().max(high.abs()));
    match *shape {
        Shape::Sphere { center, radius } => max_abs(center) + radius,
        Shape::Ellipsoid { center, radii } => max_abs(center) + radii.greatest(),
        Shape::Cylinder { origin, radius, y } => max_abs(origin) + radius.max(end(y)),
        Shape::Cone {
            origin, radius, y, ..
        } => max_abs(origin) + radius.max(end(y)),
        Shape::Paraboloid { origin, y } => max_abs(origin) + end(y),
        Shape::Plane { point, .. } => max_abs(point),
        Shape::Sphereflake(flake) => max_abs(flake.center) + flake.radius,
    }
}
