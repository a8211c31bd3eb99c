//! Names that other programs use for the keys of scene files.

use super::schema::{CAMERA, LIGHT, MATERIAL, OBJECT, SCENE};

/// A key, and other names for it, separated by spaces.
type Aliases = (&'static str, &'static str);

const SCENE_ALIASES: &[Aliases] = &[
    ("[camera]", "cam eye look_at fov fovy_deg"),
    ("max_depth", "depth bounces max_bounces recursion"),
    ("background", "sky bg background_color"),
    ("ambient", "ambient_light ka"),
    ("title", "name"),
    ("[[objects]]", "object sphere spheres shape shapes plane"),
    ("[[lights]]", "light lamp lamps"),
    ("[materials.NAME]", "material"),
    ("[[animation.tracks]]", "tracks keyframes"),
];

const CAMERA_ALIASES: &[Aliases] = &[
    ("eye", "position pos from origin location center"),
    ("look_at", "target to at direction dir look"),
    ("fovy_deg", "fov fovy field_of_view angle vfov"),
];

const LIGHT_ALIASES: &[Aliases] = &[
    ("position", "pos location origin center point at"),
    ("color", "colour intensity power brightness kd le"),
];

const MATERIAL_ALIASES: &[Aliases] = &[
    ("le", "ke emission emissive emit glow"),
    ("ka", "ambient"),
    ("kd", "diffuse color colour albedo base_color"),
    ("ks", "specular highlight"),
    ("kr", "refl reflect reflection reflectivity mirror"),
    ("kt", "transmission transmittance transparency refract tf"),
    ("ior", "n ni eta index refraction refractive_index"),
    ("shininess", "exponent gloss glossiness ns"),
    ("model", "shading"),
];

const OBJECT_ALIASES: &[Aliases] = &[
    ("type", "kind shape"),
    ("material", "mat color colour texture kd"),
    ("radius", "r"),
    ("normal", "n"),
];

/// Names for the position of an object. The right key depends on the object's type.
const POSITION_ALIASES: &str = "position pos location origin center point";

/// Returns the key for which `key` is another name. `table` is the name of the table that contains
/// `key`, and `known` are the keys of this table.
pub(super) fn alias(table: &str, known: &[&'static str], key: &str) -> Option<&'static str> {
    let key = key.to_lowercase();
    let is_listed = |names: &str| names.split(' ').any(|name| name == key);
    let is_object = OBJECT.keys.iter().all(|key| known.contains(key));
    let aliases = match table {
        _ if table == SCENE.name => SCENE_ALIASES,
        _ if table == CAMERA.name => CAMERA_ALIASES,
        _ if table == LIGHT.name => LIGHT_ALIASES,
        _ if table == MATERIAL.name => MATERIAL_ALIASES,
        _ if is_object && is_listed(POSITION_ALIASES) => {
            let mut positions = ["center", "origin", "point"].into_iter();
            return positions.find(|position| known.contains(position));
        }
        _ if is_object => OBJECT_ALIASES,
        _ => return None,
    };
    let right = aliases.iter().find(|(_, names)| is_listed(names))?.0;
    // A plane, for example, has no radius.
    (!is_object || known.contains(&right)).then_some(right)
}
