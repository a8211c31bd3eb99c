//! Readers of the types of objects. Each type has its own file.

mod cone;
mod cylinder;
mod ellipsoid;
mod paraboloid;
mod plane;
mod sphere;
mod sphereflake;

use super::shape_reader::ShapeReader;

/// Readers of all types of objects. A new type needs a file and an entry here.
pub(super) const SHAPES: [ShapeReader; 7] = [
    sphere::READER,
    ellipsoid::READER,
    cylinder::READER,
    cone::READER,
    paraboloid::READER,
    plane::READER,
    sphereflake::READER,
];
