use crate::{MaterialId, Real, Vec3};

/// A shape and what covers it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Object {
    /// Its surface.
    pub shape: Shape,
    /// What covers it.
    pub texture: Texture,
}

impl Object {
    /// A sphere of one material.
    pub const fn sphere(center: Vec3<Real>, radius: Real, material: MaterialId) -> Self {
        Self {
            shape: Shape::Sphere { center, radius },
            texture: Texture::Uniform(material),
        }
    }

    /// An endless level floor through `y`, seen from above.
    pub const fn floor(y: Real, texture: Texture) -> Self {
        Self {
            shape: Shape::Plane {
                normal: Vec3::new(Real::ZERO, Real::ONE, Real::ZERO),
                point: Vec3::new(Real::ZERO, y, Real::ZERO),
                bounds: Bounds::NONE,
            },
            texture,
        }
    }
}

/// A surface, given by an implicit function; its normal is the gradient.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Shape {
    /// A sphere. Closed.
    Sphere {
        /// Its center.
        center: Vec3<Real>,
        /// Its radius, above 0.
        radius: Real,
    },
    /// A plane, endless or bounded per axis. An endless one bounds the
    /// half-space behind its normal; a bounded one is open.
    Plane {
        /// Any length but 0.
        normal: Vec3<Real>,
        /// Any point of the plane.
        point: Vec3<Real>,
        /// Where it ends.
        bounds: Bounds,
    },
}

/// Bounds per axis in world coordinates, low and high.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Bounds {
    /// Along x; `None` is endless.
    pub x: Option<[Real; 2]>,
    /// Along y.
    pub y: Option<[Real; 2]>,
    /// Along z.
    pub z: Option<[Real; 2]>,
}

impl Bounds {
    /// Endless in every direction.
    pub const NONE: Self = Self {
        x: None,
        y: None,
        z: None,
    };
}

/// What covers a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Texture {
    /// One material all over.
    Uniform(MaterialId),
    /// A checkerboard: the first material where the sum over both axes of
    /// `floor(coordinate / size)` is even, in world coordinates, else the second.
    Checker {
        /// Length of a cell's side, above 0.
        size: Real,
        /// The two axes, different ones.
        axes: [Axis; 2],
        /// For even and for odd cells.
        materials: [MaterialId; 2],
    },
}

/// A coordinate axis.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Axis {
    /// To the right.
    #[default]
    X,
    /// Up.
    Y,
    /// Towards the viewer.
    Z,
}
