//! Each surface in the formats of tracing.

use fixed::types::I8F56;

use crate::geometry::{
    ClipBox, Cone, Cylinder, Ellipsoid, Form, Normalization, Paraboloid, Plane, Quadric, Shape,
    Sphere, Sphereflake, SphereflakeParams,
};
use crate::math::{Length, Real, Unit, Vec3, direction};
use crate::scene;
use crate::scene::{SceneError, SceneItem, SceneProblem};

use crate::geometry::limits::fail;
use crate::geometry::{below_one, cone_radius, limits as range, paraboloid_ends};

pub(super) fn shape(
    shape: &scene::Shape,
    frame: &Normalization,
    item: SceneItem,
) -> Result<Shape, SceneError> {
    let least_size = |field, size| range::least_size(item, field, size, frame);
    match *shape {
        scene::Shape::Sphere { center, radius } => {
            least_size("radius", radius)?;
            Ok(Shape::Sphere(Sphere::new(
                frame.point(center),
                frame.size(radius),
            )))
        }
        scene::Shape::Ellipsoid { center, radii } => {
            let shortest = radii.x.min(radii.y).min(radii.z);
            least_size("radii", shortest)?;
            Ok(Shape::Quadric(Quadric {
                center: frame.point(center),
                clamp: None,
                form: Form::Ellipsoid(Ellipsoid {
                    squeeze: radii.map(|radius| unit_ratio(shortest, radius)),
                    radius: frame.size(shortest),
                }),
            }))
        }
        scene::Shape::Cylinder { origin, radius, y } => {
            least_size("radius", radius)?;
            let form = Form::Cylinder(Cylinder {
                radius: frame.size(radius),
            });
            Ok(match y {
                Some(y) => clamped(origin, y, frame, form),
                None => Shape::Quadric(Quadric {
                    // Any height will do.
                    center: Vec3 {
                        y: Length::ZERO,
                        ..frame.point(origin)
                    },
                    clamp: None,
                    form,
                }),
            })
        }
        scene::Shape::Cone {
            origin,
            radius,
            height,
            y,
        } => {
            least_size("radius", radius)?;
            least_size("height", height)?;
            let form = |middle| Form::Cone(cone(radius, height, middle, frame));
            Ok(match y {
                Some(y) => clamped(origin, y, frame, form(middle(y))),
                None => Shape::Quadric(Quadric {
                    center: frame.point(origin),
                    clamp: None,
                    form: form(Real::ZERO),
                }),
            })
        }
        scene::Shape::Paraboloid { origin, y } => {
            range::least_rise(item, y, frame)?;
            let y = paraboloid_ends(y);
            let form = Form::Paraboloid(paraboloid(middle(y), frame));
            Ok(clamped(origin, y, frame, form))
        }
        scene::Shape::Plane {
            normal,
            point,
            bounds,
        } => plane(normal, point, bounds, frame, item),
        scene::Shape::Sphereflake {
            center,
            radius,
            depth,
            ratio,
            frame: axes,
        } => {
            let ratio = below_one(ratio);
            least_size("radius", radius)?;
            range::least_sphere(item, radius, ratio, depth, frame)?;
            let Some(axes) = orthonormal(axes) else {
                return fail(item, "frame", SceneProblem::NotOrthonormal);
            };
            Ok(Shape::Sphereflake(Sphereflake::new(SphereflakeParams {
                center: frame.point(center),
                frame: axes,
                radius: frame.fraction(radius),
                ratio,
                depth,
            })))
        }
    }
}

/// What is counted from, so that a clamp far from its origin is as exact as any.
fn middle([low, high]: [Real; 2]) -> Real {
    Real::from_bits((low.to_bits() + high.to_bits()) >> 1)
}

fn clamped(origin: Vec3<Real>, y: [Real; 2], frame: &Normalization, form: Form) -> Shape {
    let above = |y: Real| Vec3 {
        y: origin.y + y,
        ..origin
    };
    Shape::Quadric(Quadric {
        center: frame.point(above(middle(y))),
        clamp: Some(y.map(|y| frame.point(above(y)).y)),
        form,
    })
}

/// `n / d` of numbers above 0, n no more than d; below 0 if d is.
fn unit_ratio(n: Real, d: Real) -> Unit {
    let (n, d) = (i128::from(n.to_bits()), i128::from(d.to_bits()));
    let rounded = (n << 30) + (d.abs() >> 1);
    let quotient = rounded.checked_div(d.abs()).unwrap_or(0);
    Unit::from_bits((quotient * d.signum()) as i32)
}

fn cone(radius: Real, height: Real, middle: Real, frame: &Normalization) -> Cone {
    let half = Unit::ONE / 2;
    if radius <= height.abs() {
        Cone {
            radial: half,
            axial: unit_ratio(radius, height) / 2,
            radius: frame.half_size(cone_radius(radius, height, middle)),
        }
    } else {
        Cone {
            radial: unit_ratio(height.abs(), radius) / 2,
            axial: half * height.to_bits().signum() as i32,
            radius: frame.half_size((height - middle).to_bits() * height.to_bits().signum()),
        }
    }
}

fn paraboloid(middle: Real, frame: &Normalization) -> Paraboloid {
    // x² + z² = y 2^exponent; squeezed, the exponent is at most 0.
    let squeeze = (frame.exponent.max(0) + 1) / 2;
    Paraboloid {
        radius_squared: I8F56::from_bits(frame.square(middle.to_bits()) >> (2 * squeeze)),
        squeeze: squeeze as u8,
        focus: (2 * squeeze - frame.exponent) as u8,
    }
}

fn plane(
    normal: Vec3<Real>,
    point: Vec3<Real>,
    bounds: scene::ClipBox,
    frame: &Normalization,
    item: SceneItem,
) -> Result<Shape, SceneError> {
    let Some(normal) = direction(normal.map(Real::to_bits)) else {
        return fail(item, "normal", SceneProblem::NoDirection);
    };
    let Some(offset) = frame.offset(normal, point) else {
        return fail(item, "point", frame.reach_problem());
    };
    let [x, y, z] = [
        (bounds.x, frame.center.x),
        (bounds.y, frame.center.y),
        (bounds.z, frame.center.z),
    ]
    .map(|(bound, center)| {
        bound.map_or([Length::MIN, Length::MAX], |bound| {
            bound.map(|b| Length::from_bits(frame.length(b.to_bits() - center) as i32))
        })
    });
    let bounds = (bounds != scene::ClipBox::NONE).then_some(ClipBox {
        low: Vec3::new(x[0], y[0], z[0]),
        high: Vec3::new(x[1], y[1], z[1]),
    });
    Ok(Shape::Plane(Plane::new(normal, offset, bounds)))
}

/// u and v of a frame, made exact; `None` if its rows are not nearly
/// orthonormal and right-handed.
fn orthonormal([u, v, w]: [Vec3<Real>; 3]) -> Option<[Vec3<Unit>; 2]> {
    /// 0.001: rows may be written down with three digits.
    const MARGIN: Real = Real::lit("0.001");
    let product = |a: Vec3<Real>, b: Vec3<Real>| {
        let sum = a.zip(b, Real::saturating_mul);
        sum.x.saturating_add(sum.y).saturating_add(sum.z)
    };
    let is_unit = |v| (product(v, v).saturating_sub(Real::ONE)).abs() < 2 * MARGIN;
    let are_square = |a, b| product(a, b).abs() < MARGIN;
    if ![u, v, w].into_iter().all(is_unit) || !are_square(u, v) {
        return None;
    }
    let [u, v, w] = [u, v, w].map(|row| direction(row.map(Real::to_bits)));
    let (u, v, w) = (u?, v?, w?);
    let exact = direction(u.cross(v))?;
    // Within some thousandths of the row itself.
    if exact.dot(w).to_bits() < (1 << 60) - (1 << 50) * 16 {
        return None;
    }
    Some([u, direction(exact.cross(u))?])
}
