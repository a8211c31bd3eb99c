//! Names and keys of the tables of a scene file.

/// Keys that one kind of TOML table accepts.
#[derive(Clone, Copy, Debug)]
pub struct TableSchema {
    /// Name of the table with its article, as error messages print it, such as "a light".
    pub name: &'static str,
    /// Accepted keys, in the order in which error messages list them.
    pub keys: &'static [&'static str],
}

/// Keys at the top level of a scene file.
pub(super) const SCENE: TableSchema = TableSchema {
    name: "a scene",
    keys: &[
        "title",
        "max_depth",
        "min_weight",
        "shading",
        "ambient",
        "background",
        "transfer",
        "camera",
        "lights",
        "materials",
        "objects",
        "animation",
    ],
};

pub(super) const CAMERA: TableSchema = TableSchema {
    name: "the camera",
    keys: &["eye", "look_at", "up", "fovy_deg"],
};

/// Keys of a background that blends two colors.
pub(super) const BACKGROUND: TableSchema = TableSchema {
    name: "the background",
    keys: &["horizon", "zenith"],
};

pub(super) const LIGHT: TableSchema = TableSchema {
    name: "a light",
    keys: &["position", "color", "diffuse", "specular", "name"],
};

pub(super) const MATERIAL: TableSchema = TableSchema {
    name: "a material",
    keys: &[
        "ka",
        "kd",
        "ks",
        "shininess",
        "kr",
        "kt",
        "ior",
        "le",
        "model",
    ],
};

/// Keys that objects of every type accept. Each type adds its own keys.
pub(super) const OBJECT: TableSchema = TableSchema {
    name: "an object",
    keys: &["type", "material", "checker", "name"],
};

pub(super) const CHECKER: TableSchema = TableSchema {
    name: "`checker`",
    keys: &["size", "axes", "materials"],
};

pub(super) const BOUNDS: TableSchema = TableSchema {
    name: "`bounds`",
    keys: &["x", "y", "z"],
};

pub(super) const ANIMATION: TableSchema = TableSchema {
    name: "an animation",
    keys: &["duration", "loop", "tracks"],
};

pub(super) const TRACK: TableSchema = TableSchema {
    name: "a track",
    keys: &["target", "interpolation", "keys"],
};
