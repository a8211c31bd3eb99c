use whitted::scene::ClipBox;
use whitted::{Real, Shape, Vec3};

/// Returns true if a point is inside a closed surface. Open surfaces have no inside, and only the
/// largest sphere of a sphereflake counts.
///
/// The result serves warnings only, so floating point is exact enough.
pub(super) fn is_inside(shape: &Shape, point: Vec3<Real>) -> bool {
    match *shape {
        Shape::Sphere { center, radius } | Shape::Sphereflake { center, radius, .. } => {
            let [x, y, z] = from(center, point);
            x * x + y * y + z * z < square(radius)
        }
        Shape::Ellipsoid { center, radii } => {
            let ([x, y, z], [a, b, c]) = (from(center, point), floats(radii));
            (x / a).powi(2) + (y / b).powi(2) + (z / c).powi(2) < 1.0
        }
        Shape::Cylinder {
            origin,
            radius,
            y: None,
        } => {
            let [x, _, z] = from(origin, point);
            x * x + z * z < square(radius)
        }
        Shape::Cone {
            origin,
            radius,
            height,
            y: None,
        } => {
            let ([x, y, z], height) = (from(origin, point), height.to_num::<f64>());
            x * x + z * z < square(radius) * (1.0 - y / height).powi(2)
        }
        Shape::Plane {
            normal,
            point: origin,
            bounds: ClipBox::NONE,
        } => {
            let products = from(origin, point).into_iter().zip(floats(normal));
            products.map(|(a, b)| a * b).sum::<f64>() < 0.0
        }
        _ => false,
    }
}

/// Returns the vector from `origin` to `point`.
fn from(origin: Vec3<Real>, point: Vec3<Real>) -> [f64; 3] {
    let ([x, y, z], [a, b, c]) = (floats(point), floats(origin));
    [x - a, y - b, z - c]
}

fn floats(Vec3 { x, y, z }: Vec3<Real>) -> [f64; 3] {
    [x, y, z].map(Real::to_num)
}

fn square(number: Real) -> f64 {
    number.to_num::<f64>().powi(2)
}
