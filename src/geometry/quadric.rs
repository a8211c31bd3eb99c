//! Surfaces of the second degree around the y axis, and ellipsoids.
//!
//! Each form gives the quadratic equation of a ray and the gradient at a point;
//! what follows from them is here, the same for all.

mod cone;
mod cylinder;
mod ellipsoid;
mod paraboloid;
mod quadratic;

pub(crate) use cone::Cone;
pub(crate) use cylinder::Cylinder;
pub(crate) use ellipsoid::Ellipsoid;
pub(crate) use paraboloid::Paraboloid;

use quadratic::Quadratic;

use crate::geometry::bounds::BoundingSphere;

use crate::geometry::{HORIZON, Point, Ray};
use crate::math::{
    Length, Product, SoftFloat, Square, Unit, Vec3, direction, round_length, square_root,
};

/// A surface of the second degree.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Quadric {
    /// A point that the form's coordinates count from, within ±1.
    pub(crate) center: Vec3<Length>,
    /// Where along y it begins and ends.
    pub(crate) clamp: Option<[Length; 2]>,
    pub(crate) form: Form,
}

/// What a quadric can be.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Form {
    Ellipsoid(Ellipsoid),
    Cylinder(Cylinder),
    Cone(Cone),
    Paraboloid(Paraboloid),
}

impl Default for Form {
    fn default() -> Self {
        Self::Cylinder(Cylinder::default())
    }
}

impl Quadric {
    /// Whether it has points beyond the finite geometry.
    #[inline]
    pub(crate) fn is_endless(&self) -> bool {
        self.clamp.is_none() && !matches!(self.form, Form::Ellipsoid(_))
    }

    /// A sphere around all of it; `None` if it is endless.
    pub(crate) fn bounding_sphere(&self) -> Option<BoundingSphere> {
        /// Finite geometry is within ±1, so that nothing is farther away from
        /// something finite.
        const FARTHEST: Length = Length::lit("3.5");
        /// More than roundings take.
        const MARGIN: Length = Length::lit("0.000001");

        if self.is_endless() {
            return None;
        }
        let height = self.clamp.map_or(Length::ZERO, |[low, high]| {
            (high - self.center.y).max(self.center.y - low)
        });
        let width = match &self.form {
            Form::Ellipsoid(form) => form.longest(),
            Form::Cylinder(form) => Some(form.radius),
            Form::Cone(form) => form.widest(height),
            Form::Paraboloid(form) => form.widest(height),
        };
        let width = width.map_or(FARTHEST, |width| width.min(FARTHEST));
        let square = width.square() + height.square();
        let radius = Length::from_bits(square_root(square.to_bits() as u64) as i32);
        Some(BoundingSphere {
            center: self.center,
            radius: (radius + MARGIN).min(FARTHEST),
        })
    }

    /// Whether it bounds no inside.
    #[inline]
    pub(crate) fn is_open(&self) -> bool {
        self.clamp.is_some()
    }

    /// Where a ray crosses it ahead, in no order. A finite one is met from near
    /// origins only.
    ///
    /// `start` says whether a ray that starts on it is `inward`: then one root
    /// is known to be the start, and the other needs no square root.
    #[inline(never)]
    pub(crate) fn crossings(&self, ray: &Ray, start: Option<bool>) -> [Option<SoftFloat>; 2] {
        let quadratic = self.quadratic(ray);
        let mut roots = match start {
            None => quadratic.roots(),
            Some(inward) => [quadratic.across(inward), None],
        };
        for root in &mut roots {
            if let Some(distance) = root {
                distance.exponent += i32::from(ray.origin.shift);
                if !self.reaches(ray, *distance) {
                    *root = None;
                }
            }
        }
        roots
    }

    /// The nearest of them.
    #[inline]
    pub(crate) fn nearest(&self, ray: &Ray, start: Option<bool>) -> Option<SoftFloat> {
        match self.crossings(ray, start) {
            [Some(first), Some(second)] => Some(first.min(second)),
            [first, second] => first.or(second),
        }
    }

    #[inline]
    fn quadratic(&self, ray: &Ray) -> Quadratic {
        let Point { shift, .. } = ray.origin;
        let offset = -ray.origin.to(self.center);
        match &self.form {
            Form::Ellipsoid(form) => form.quadratic(offset, ray.direction),
            Form::Cylinder(form) => form.quadratic(offset, ray.direction, shift),
            Form::Cone(form) => form.quadratic(offset, ray.direction, shift),
            Form::Paraboloid(form) => form.quadratic(offset, ray.direction),
        }
    }

    /// Whether the surface is there: within its clamp, or before the horizon.
    #[inline(never)]
    fn reaches(&self, ray: &Ray, distance: SoftFloat) -> bool {
        let Some([low, high]) = self.clamp else {
            return distance.exponent <= HORIZON;
        };
        distance.near().is_some_and(|distance| {
            let rise = round_length::<30>(ray.direction.y.product(distance).to_bits());
            let y = ray.origin.coordinates.y.saturating_add(rise);
            low <= y && y <= high
        })
    }

    /// The unit normal at a point, outward or away from the axis; zero at the
    /// apex of a cone.
    #[inline(never)]
    pub(crate) fn normal(&self, point: Point) -> Vec3<Unit> {
        let offset = -point.to(self.center);
        let gradient = match &self.form {
            Form::Ellipsoid(form) => form.gradient(offset),
            Form::Cylinder(form) => form.gradient(offset),
            Form::Cone(form) => form.gradient(offset, point.shift),
            Form::Paraboloid(form) => form.gradient(offset),
        };
        direction(gradient).unwrap_or(Vec3::new(Unit::ZERO, Unit::ZERO, Unit::ZERO))
    }
}
