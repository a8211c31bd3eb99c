//! Readers of the types of objects. Each type has its own file.

mod cone;
mod cylinder;
mod ellipsoid;
mod paraboloid;
mod plane;
mod sphere;
mod sphereflake;

use super::shape_reader::ShapeReader;

/// One reader for each type of object. A new type of object needs its own file and an entry in this
/// array.
pub(super) const SHAPES: [ShapeReader; 7] = [
    sphere::READER,
    ellipsoid::READER,
    cylinder::READER,
    cone::READER,
    paraboloid::READER,
    plane::READER,
    sphereflake::READER,
];
