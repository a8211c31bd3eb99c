//! What tracing relies on: the range of every field.

use fixed::types::{I8F56, U0F32};

use crate::num::{Factor, Length, Unit, wide};
use crate::prepared::{
    Camera, FINEST, Frame, Light, MAX_DEPTH, Material, OFFSET_BITS, Object, Settings,
};
use crate::ray::NEAR;
use crate::shape::{Form, MAX_FLAKE_DEPTH, Parts, Quadric, Shape, Sphereflake};
use crate::texture::Texture;
use crate::{Color, Vec3};

fn is_within_one(point: Vec3<Length>) -> bool {
    point.all(|c| c.abs() <= Length::ONE)
}

fn is_unit(v: Vec3<Unit>) -> bool {
    // Within 2^-20 of 1.
    let excess = v.dot(v).to_bits() - (1 << 60);
    v.all(|c| c.abs() <= Unit::ONE) && excess.abs() < 1 << 40
}

/// A radius.
fn is_size(length: Length) -> bool {
    (Length::DELTA..=Length::ONE).contains(&length)
}

fn are_factors<const N: usize>(colors: [Color<Factor>; N]) -> bool {
    colors
        .into_iter()
        .all(|color| color.all(|c| c <= Factor::ONE))
}

impl Settings {
    pub(super) fn is_valid(&self) -> bool {
        let Camera {
            eye,
            forward,
            right,
            up,
            tangent,
        } = self.camera;
        eye.all(|c| c.to_bits().abs() <= NEAR)
            && [forward, right, up].into_iter().all(is_unit)
            && (1..12 << 28).contains(&tangent)
            && self.frame.is_valid()
            && are_factors([self.horizon, self.zenith])
            && self.exposure < 16
            && self.max_depth <= MAX_DEPTH
            && self.min_weight <= Factor::ONE
    }
}

impl Frame {
    fn is_valid(&self) -> bool {
        self.center.all(|c| c.unsigned_abs() < 1 << 60) && (-32..=FINEST).contains(&self.exponent)
    }
}

impl Light {
    pub(super) fn is_valid(&self) -> bool {
        is_within_one(self.position) && are_factors([self.diffuse, self.specular])
    }
}

impl Material {
    pub(super) fn is_valid(&self) -> bool {
        are_factors([self.kd, self.ks, self.kr, self.kt])
            && (1 << 16..=4096 << 16).contains(&self.shininess)
            && (Length::ONE..=const { Length::lit("4") }).contains(&self.ior)
            && (Length::ONE / 4..=Length::ONE).contains(&self.inverse_ior)
    }
}

impl Object {
    pub(super) fn is_valid(&self, materials: u16) -> bool {
        let shape = match &self.shape {
            Shape::Sphere(sphere) => is_within_one(sphere.center) && is_size(sphere.radius),
            Shape::Plane(plane) => {
                is_unit(plane.normal) && plane.offset.unsigned_abs() < 1 << OFFSET_BITS
            }
            Shape::Quadric(quadric) => quadric.is_valid(),
            Shape::Sphereflake(flake) => flake.parts().is_valid(),
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
                squeeze.contains(&form.radial)
                    && squeeze.contains(&form.axial.abs())
                    && form.radial.max(form.axial.abs()) <= Unit::ONE / 2
                    && form.radius.abs() <= Length::ONE
            }
            Form::Paraboloid(form) => {
                self.clamp.is_some()
                    && form.radius_squared.abs() <= I8F56::ONE
                    && form.squeeze <= 2
                    && form.focus <= 31
            }
        };
        form && is_within_one(self.center)
            && self
                .clamp
                .is_none_or(|ends| ends.into_iter().all(|y| y.abs() <= Length::ONE))
    }
}

impl Parts {
    fn is_valid(&self) -> bool {
        let [u, v] = self.frame;
        let reach = wide(
            self.radius.to_bits(),
            Sphereflake::bound(self.ratio, self.depth).to_bits() as u32,
        );
        is_within_one(self.center)
            && is_unit(u)
            && is_unit(v)
            && u.cosine(v).abs() <= Unit::DELTA * (1 << 10)
            && self.depth <= MAX_FLAKE_DEPTH
            && (const { U0F32::lit("0.099") }..=const { U0F32::lit("0.5") }).contains(&self.ratio)
            && self.radius > 0
            && reach <= 1 << 61
    }
}
