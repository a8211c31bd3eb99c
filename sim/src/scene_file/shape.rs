use whitted::{Bounds, Shape};

use super::error::LoadError;
use super::keys::{Keys, Kind};

/// What a type of object is written as.
#[derive(Clone, Copy)]
pub(super) struct Form {
    pub(super) kind: Kind,
    /// Comes after the keys were found to be those of the kind.
    pub(super) read: fn(&Keys<'_>) -> Result<Shape, LoadError>,
}

/// The types of objects. A new one needs a row here and a function below.
pub(super) const SHAPES: [(&str, Form); 2] = [("sphere", SPHERE), ("plane", PLANE)];

/// Types of the scene format that the library does not have yet.
pub(super) const PLANNED: [&str; 5] =
    ["ellipsoid", "cylinder", "cone", "paraboloid", "sphereflake"];

const SPHERE: Form = Form {
    kind: Kind {
        name: "a sphere",
        keys: &["type", "center", "radius", "material", "checker"],
    },
    read: sphere,
};

fn sphere(keys: &Keys<'_>) -> Result<Shape, LoadError> {
    let need = |key| keys.need(key, SPHERE.kind.name);
    Ok(Shape::Sphere {
        center: need("center")?.vector()?,
        radius: need("radius")?.number()?,
    })
}

const PLANE: Form = Form {
    kind: Kind {
        name: "a plane",
        keys: &["type", "normal", "point", "bounds", "material", "checker"],
    },
    read: plane,
};

fn plane(keys: &Keys<'_>) -> Result<Shape, LoadError> {
    let need = |key| keys.need(key, PLANE.kind.name);
    Ok(Shape::Plane {
        normal: need("normal")?.vector()?,
        point: need("point")?.vector()?,
        bounds: bounds(keys)?,
    })
}

const BOUNDS: Kind = Kind {
    name: "`bounds`",
    keys: &["x", "y", "z"],
};

fn bounds(keys: &Keys<'_>) -> Result<Bounds, LoadError> {
    let Some(value) = keys.get("bounds") else {
        return Ok(Bounds::NONE);
    };
    let keys = Keys::of(&value, "a table of intervals")?;
    keys.only(BOUNDS)?;
    let interval = |key| keys.get(key).map(|value| value.interval()).transpose();
    Ok(Bounds {
        x: interval("x")?,
        y: interval("y")?,
        z: interval("z")?,
    })
}
