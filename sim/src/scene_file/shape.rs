//! The types of objects, one file each.

mod cone;
mod cylinder;
mod ellipsoid;
mod paraboloid;
mod plane;
mod sphere;
mod sphereflake;

use whitted::Shape;

use super::error::LoadError;
use super::keys::{Keys, Kind};

/// What a type of object is written as.
#[derive(Clone, Copy)]
pub(super) struct Form {
    /// What a scene file calls the type.
    pub(super) name: &'static str,
    pub(super) kind: Kind,
    /// Comes after the keys were found to be those of the kind.
    pub(super) read: fn(&Keys<'_>) -> Result<Shape, LoadError>,
}

/// The types of objects. A new one needs a row here and a file.
pub(super) const SHAPES: [Form; 7] = [
    sphere::FORM,
    ellipsoid::FORM,
    cylinder::FORM,
    cone::FORM,
    paraboloid::FORM,
    plane::FORM,
    sphereflake::FORM,
];
