//! The fields of each item, in the order in which they are stored.

use crate::geometry::{
    Checker, ClipBox, Cone, Cylinder, Ellipsoid, Form, Normalization, Paraboloid, Plane, Quadric,
    Shape, Sphere, Sphereflake, SphereflakeParams, Texture,
};
use crate::math::Vec3;
use crate::prepare::{Camera, Light, Material, Object, Settings};
use crate::scene;
use crate::scene::Axis;

use crate::archive::{Archive, Fields, color, fixed, vector};

impl Fields for Settings {
    #[inline(never)]
    fn visit(&mut self, archive: &mut impl Archive) {
        let Camera {
            eye,
            forward,
            right,
            up,
            tangent,
        } = &mut self.camera;
        vector(eye, archive);
        vector(forward, archive);
        vector(right, archive);
        vector(up, archive);
        tangent.visit(archive);
        let scene::Camera {
            eye,
            look_at,
            up,
            fovy_deg,
        } = &mut self.authored;
        vector(eye, archive);
        vector(look_at, archive);
        vector(up, archive);
        fixed(fovy_deg, archive);
        let Normalization { center, exponent } = &mut self.frame;
        center.x.visit(archive);
        center.y.visit(archive);
        center.z.visit(archive);
        exponent.visit(archive);
        color(&mut self.horizon, archive);
        color(&mut self.zenith, archive);
        self.is_gradient = self.horizon != self.zenith;
        self.exposure.visit(archive);
        self.max_depth.visit(archive);
        fixed(&mut self.min_weight, archive);
    }
}

impl Fields for Light {
    #[inline(never)]
    fn visit(&mut self, archive: &mut impl Archive) {
        vector(&mut self.position, archive);
        color(&mut self.diffuse, archive);
        color(&mut self.specular, archive);
    }
}

impl Fields for Material {
    #[inline(never)]
    fn visit(&mut self, archive: &mut impl Archive) {
        color(&mut self.glow, archive);
        color(&mut self.kd, archive);
        color(&mut self.ks, archive);
        color(&mut self.kr, archive);
        color(&mut self.kt, archive);
        self.shininess.visit(archive);
        fixed(&mut self.ior, archive);
        fixed(&mut self.inverse_ior, archive);
        let mut blinn = u8::from(self.blinn);
        blinn.visit(archive);
        self.blinn = blinn != 0;
    }
}

impl Fields for Object {
    #[inline(never)]
    fn visit(&mut self, archive: &mut impl Archive) {
        self.shape.visit(archive);
        self.texture.visit(archive);
        self.nature = self.shape.nature();
    }
}

/// How the kinds of shapes are told apart.
mod kind {
    pub(super) const SPHERE: u8 = 0;
    pub(super) const PLANE: u8 = 1;
    pub(super) const BOUNDED_PLANE: u8 = 2;
    pub(super) const ELLIPSOID: u8 = 3;
    pub(super) const CYLINDER: u8 = 4;
    pub(super) const CONE: u8 = 5;
    pub(super) const PARABOLOID: u8 = 6;
    pub(super) const SPHEREFLAKE: u8 = 7;
}

fn kind_of(shape: &Shape) -> u8 {
    match shape {
        Shape::Sphere(_) => kind::SPHERE,
        Shape::Plane(Plane { bounds: None, .. }) => kind::PLANE,
        Shape::Plane(_) => kind::BOUNDED_PLANE,
        Shape::Quadric(quadric) => match quadric.form {
            Form::Ellipsoid(_) => kind::ELLIPSOID,
            Form::Cylinder(_) => kind::CYLINDER,
            Form::Cone(_) => kind::CONE,
            Form::Paraboloid(_) => kind::PARABOLOID,
        },
        Shape::Sphereflake(_) => kind::SPHEREFLAKE,
    }
}

/// The shape that a kind begins with, before its fields are read.
fn blank(kind: u8) -> Shape {
    let form = match kind {
        kind::PLANE | kind::BOUNDED_PLANE => {
            let bounds = (kind == kind::BOUNDED_PLANE).then_some(ClipBox::ENDLESS);
            return Shape::Plane(Plane::new(Vec3::default(), 0, bounds));
        }
        kind::ELLIPSOID => Form::Ellipsoid(Ellipsoid::default()),
        kind::CYLINDER => Form::Cylinder(Cylinder::default()),
        kind::CONE => Form::Cone(Cone::default()),
        kind::PARABOLOID => Form::Paraboloid(Paraboloid::default()),
        kind::SPHEREFLAKE => return Shape::Sphereflake(Sphereflake::default()),
        // An unknown kind becomes a sphere without a radius, which is not valid.
        _ => return Shape::Sphere(Sphere::default()),
    };
    Shape::Quadric(Quadric {
        form,
        ..Quadric::default()
    })
}

impl Fields for Shape {
    #[inline(never)]
    fn visit(&mut self, archive: &mut impl Archive) {
        let kind = kind_of(self);
        let mut read = kind;
        read.visit(archive);
        if read != kind {
            *self = blank(read);
        }
        match self {
            Self::Sphere(sphere) => sphere.visit(archive),
            Self::Plane(plane) => plane.visit(archive),
            Self::Quadric(quadric) => quadric.visit(archive),
            Self::Sphereflake(flake) => flake.visit(archive),
        }
    }
}

impl Fields for Sphere {
    fn visit(&mut self, archive: &mut impl Archive) {
        let Self {
            mut center,
            mut radius,
            ..
        } = *self;
        vector(&mut center, archive);
        fixed(&mut radius, archive);
        *self = Self::new(center, radius);
    }
}

impl Fields for Plane {
    fn visit(&mut self, archive: &mut impl Archive) {
        vector(&mut self.normal, archive);
        self.offset.visit(archive);
        if let Some(bounds) = &mut self.bounds {
            vector(&mut bounds.low, archive);
            vector(&mut bounds.high, archive);
        }
        *self = self.complete();
    }
}

impl Fields for Quadric {
    #[inline(never)]
    fn visit(&mut self, archive: &mut impl Archive) {
        vector(&mut self.center, archive);
        let mut clamped = u8::from(self.clamp.is_some());
        clamped.visit(archive);
        let [mut low, mut high] = self.clamp.unwrap_or_default();
        fixed(&mut low, archive);
        fixed(&mut high, archive);
        self.clamp = (clamped != 0).then_some([low, high]);
        match &mut self.form {
            Form::Ellipsoid(form) => {
                vector(&mut form.squeeze, archive);
                fixed(&mut form.radius, archive);
            }
            Form::Cylinder(form) => fixed(&mut form.radius, archive),
            Form::Cone(form) => {
                fixed(&mut form.radial, archive);
                fixed(&mut form.axial, archive);
                fixed(&mut form.radius, archive);
            }
            Form::Paraboloid(form) => {
                fixed(&mut form.radius_squared, archive);
                form.squeeze.visit(archive);
                form.focus.visit(archive);
            }
        }
    }
}

impl Fields for Sphereflake {
    #[inline(never)]
    fn visit(&mut self, archive: &mut impl Archive) {
        let SphereflakeParams {
            mut center,
            mut frame,
            mut radius,
            mut ratio,
            mut depth,
        } = self.parts();
        vector(&mut center, archive);
        frame.iter_mut().for_each(|row| vector(row, archive));
        fixed(&mut radius, archive);
        fixed(&mut ratio, archive);
        depth.visit(archive);
        let parts = SphereflakeParams {
            center,
            frame,
            radius,
            ratio,
            depth,
        };
        // What follows from the parts is only defined for valid ones; without a
        // radius it is not valid.
        *self = if parts.is_valid() {
            Self::new(parts)
        } else {
            Self::default()
        };
    }
}

impl Fields for Axis {
    #[inline(never)]
    fn visit(&mut self, archive: &mut impl Archive) {
        let mut index = *self as u8;
        index.visit(archive);
        *self = match index {
            0 => Self::X,
            1 => Self::Y,
            _ => Self::Z,
        };
    }
}

impl Fields for Texture {
    #[inline(never)]
    fn visit(&mut self, archive: &mut impl Archive) {
        const UNIFORM: u8 = 0;
        const CHECKER: u8 = 1;
        let mut kind = match self {
            Self::Uniform(_) => UNIFORM,
            Self::Checker(_) => CHECKER,
        };
        kind.visit(archive);
        *self = if kind == UNIFORM {
            let mut material = match *self {
                Self::Uniform(material) => material,
                Self::Checker(_) => 0,
            };
            material.visit(archive);
            Self::Uniform(material)
        } else {
            let mut checker = match *self {
                Self::Checker(checker) => checker,
                Self::Uniform(_) => Checker::default(),
            };
            checker.mantissa.visit(archive);
            checker.exponent.visit(archive);
            checker
                .phase
                .iter_mut()
                .for_each(|phase| phase.visit(archive));
            checker.axes.iter_mut().for_each(|axis| axis.visit(archive));
            checker
                .materials
                .iter_mut()
                .for_each(|material| material.visit(archive));
            Self::Checker(checker)
        };
    }
}
