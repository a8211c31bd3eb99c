//! What tracing relies on: the range of every field.

use core::ops::Neg;

use fixed::traits::Fixed;
use fixed::types::{I8F56, U0F32};

use crate::geometry::{
    FINEST, Form, MAX_FLAKE_DEPTH, NEAR, Normalization, OFFSET_BITS, Quadric, Shape, Sphereflake,
    SphereflakeParams, Texture,
};
use crate::math::{Color, Factor, Length, Radiance, Unit, Vec3, wide};
use crate::prepare::{Camera, Light, MAX_DEPTH, Material, Object, Settings};

/// Whether it is within ±most. Not by `abs`, which the least number has none of.
fn is_within<F: Fixed + Neg<Output = F>>(value: F, most: F) -> bool {
    (-most..=most).contains(&value)
}

/// Whether each coordinate is within ±most.
///
/// What is asked for several times is not inlined, and takes references: that is less to
/// hand over.
#[inline(never)]
fn are_within(point: &Vec3<Length>, most: Length) -> bool {
    point.all(|c| is_within(c, most))
}

fn is_within_one(point: &Vec3<Length>) -> bool {
    are_within(point, Length::ONE)
}

#[inline(never)]
fn is_unit(v: &Vec3<Unit>) -> bool {
    // Within 2^-20 of 1; components beyond 1 would overflow.
    v.all(|c| is_within(c, Unit::ONE)) && (v.dot(*v).to_bits() - (1 << 60)).abs() < 1 << 40
}

/// Whether unit vectors are at right angles, to 2^-20.
#[inline(never)]
fn are_square(u: &Vec3<Unit>, v: &Vec3<Unit>) -> bool {
    is_within(u.cosine(*v), Unit::DELTA * (1 << 10))
}

/// A radius.
fn is_size(length: Length) -> bool {
    (Length::DELTA..=Length::ONE).contains(&length)
}

#[inline(never)]
fn are_factors<const N: usize>(colors: [Color<Factor>; N]) -> bool {
    colors
        .into_iter()
        .all(|color| color.all(|c| c <= Factor::ONE))
}

impl Settings {
    #[inline(never)]
    pub(super) fn is_valid(&self) -> bool {
        let Camera {
            eye,
            forward,
            right,
            up,
            tangent,
        } = &self.camera;
        are_within(eye, Length::from_bits(NEAR))
            && [forward, right, up].into_iter().all(is_unit)
            && are_square(forward, right)
            && are_square(right, up)
            && are_square(up, forward)
            && (1..12 << 28).contains(tangent)
            && self.frame.is_valid()
            && [self.horizon, self.zenith]
                .into_iter()
                .all(|color| color.all(|c| c <= Radiance::ONE))
            && self.exposure < 16
            && self.max_depth <= MAX_DEPTH
            && self.min_weight <= Factor::ONE
    }
}

impl Normalization {
    fn is_valid(&self) -> bool {
        let Vec3 { x, y, z } = self.center.map(i64::unsigned_abs);
        x | y | z < 1 << 60 && (-32..=FINEST).contains(&self.exponent)
    }
}

impl Light {
    #[inline(never)]
    pub(super) fn is_valid(&self) -> bool {
        is_within_one(&self.position) && are_factors([self.diffuse, self.specular])
    }
}

impl Material {
    #[inline(never)]
    pub(super) fn is_valid(&self) -> bool {
        are_factors([self.kd, self.ks])
            && (1 << 16..=4096 << 16).contains(&self.shininess)
            && (Length::ONE..=const { Length::lit("4") }).contains(&self.ior)
            && (Length::ONE / 4..=Length::ONE).contains(&self.inverse_ior)
    }
}

impl Object {
    #[inline(never)]
    pub(super) fn is_valid(&self, materials: u16) -> bool {
        let shape = match &self.shape {
            Shape::Sphere(sphere) => is_within_one(&sphere.center) && is_size(sphere.radius),
            Shape::Plane(plane) => {
                is_unit(&plane.normal) && plane.offset.unsigned_abs() < 1 << OFFSET_BITS
            }
            Shape::Quadric(quadric) => quadric.is_valid(),
            // Looked at as it was read: without a radius if it is not valid.
            Shape::Sphereflake(flake) => flake.parts().radius > 0,
        };
        let texture = match &self.texture {
            Texture::Uniform(material) => *material < materials,
            Texture::Checker(checker) => {
                checker.mantissa >> 31 == 1
                    && checker
                        .materials
                        .iter()
                        .all(|material| *material < materials)
            }
        };
        shape && texture
    }
}

impl Quadric {
    fn is_valid(&self) -> bool {
        let squeeze = Unit::DELTA..=Unit::ONE;
        let form = match &self.form {
            Form::Ellipsoid(form) => {
                self.clamp.is_none()
                    && form.squeeze.all(|c| squeeze.contains(&c))
                    && is_size(form.radius)
            }
            Form::Cylinder(form) => is_size(form.radius),
            Form::Cone(form) => {
                let half = Unit::ONE / 2;
                (Unit::DELTA..=half).contains(&form.radial)
                    && form.axial != 0
                    && is_within(form.axial, half)
                    && is_within(form.radius, Length::ONE)
            }
            Form::Paraboloid(form) => {
                self.clamp.is_some()
                    && (I8F56::ZERO..=I8F56::ONE).contains(&form.radius_squared)
                    && form.squeeze <= 2
                    && form.focus <= 31
            }
        };
        form && is_within_one(&self.center)
            && self
                .clamp
                .is_none_or(|ends| ends.into_iter().all(|y| is_within(y, Length::ONE)))
    }
}

impl SphereflakeParams {
    #[inline(never)]
    pub(super) fn is_valid(&self) -> bool {
        let [u, v] = &self.frame;
        is_within_one(&self.center)
            && is_unit(u)
            && is_unit(v)
            && are_square(u, v)
            && self.depth <= MAX_FLAKE_DEPTH
            && (const { U0F32::lit("0.099") }..=const { U0F32::lit("0.5") }).contains(&self.ratio)
            && self.radius > 0
            && self.reach() <= 1 << 61
    }

    /// How far the flake reaches, Q61.
    fn reach(&self) -> u64 {
        let bound = Sphereflake::bound(self.ratio, self.depth);
        wide(self.radius.to_bits(), bound.to_bits() as u32)
    }
}
