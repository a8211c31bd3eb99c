use crate::math::{Real, Vec3};

/// Surface of an object, in world units.
///
/// A closed surface separates an inside from an outside: rays that it transmits are refracted
/// at both crossings. An open surface has no inside. Axes of symmetry are parallel to y.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Shape {
    /// Sphere; closed.
    Sphere {
        /// Center.
        center: Vec3<Real>,
        /// Radius, above 0.
        radius: Real,
    },
    /// Ellipsoid `x²/a² + y²/b² + z²/c² = 1`; closed.
    Ellipsoid {
        /// Center.
        center: Vec3<Real>,
        /// Semi-axes a, b and c, above 0. The longest is at most 256 times the shortest.
        radii: Vec3<Real>,
    },
    /// Cylinder `x² + z² = r²` without caps; open if clipped by `y`, closed if unbounded.
    Cylinder {
        /// Point of the axis. `y` is relative to it.
        origin: Vec3<Real>,
        /// Radius, above 0.
        radius: Real,
        /// Low and high end along the axis; `None` for an unbounded cylinder.
        y: Option<[Real; 2]>,
    },
    /// Double cone `x² + z² = (r/h)² (y - h)²` without caps, with a circle of radius r at y = 0
    /// and the apex at y = h; open if clipped by `y`, closed if unbounded.
    Cone {
        /// Center of the circle. `y` is relative to it.
        origin: Vec3<Real>,
        /// Radius of the circle, above 0.
        radius: Real,
        /// Height of the apex over the circle, negative for a cone that stands on its apex. Its
        /// absolute value is 1/1024 to 1024 times the radius.
        height: Real,
        /// Low and high end along the axis, which may lie on both sides of the apex; `None` for an
        /// unbounded double cone.
        y: Option<[Real; 2]>,
    },
    /// Paraboloid `x² + z² = y`; open.
    Paraboloid {
        /// Vertex. `y` is relative to it.
        origin: Vec3<Real>,
        /// Low and high end along the axis. The high end is above 0.
        y: [Real; 2],
    },
    /// Plane; closed if unbounded, with the half-space behind the normal as its inside, and open
    /// if clipped.
    Plane {
        /// Normal of any length but 0.
        normal: Vec3<Real>,
        /// Point of the plane.
        point: Vec3<Real>,
        /// Box in world coordinates that clips the plane.
        bounds: ClipBox,
    },
    /// Sphereflake: a sphere touched by twelve smaller spheres, each of which is touched by twelve
    /// smaller ones, and so on; closed.
    Sphereflake {
        /// Center of the largest sphere.
        center: Vec3<Real>,
        /// Radius of the largest sphere, above 0.
        radius: Real,
        /// Number of generations of smaller spheres, 0 to 8. Six generations have 3,257,437 spheres.
        depth: u8,
        /// Ratio of a sphere's radius to the radius of its parent, 0.1 to 0.5.
        ratio: Real,
        /// Axes u, v and w of the largest sphere: a right-handed orthonormal basis.
        frame: [Vec3<Real>; 3],
    },
}

impl Shape {
    /// Returns the position, which animation tracks move.
    pub(crate) fn position_mut(&mut self) -> &mut Vec3<Real> {
        match self {
            Self::Sphere { center, .. }
            | Self::Ellipsoid { center, .. }
            | Self::Sphereflake { center, .. } => center,
            Self::Cylinder { origin, .. }
            | Self::Cone { origin, .. }
            | Self::Paraboloid { origin, .. } => origin,
            Self::Plane { point, .. } => point,
        }
    }

    /// Returns the radius, if the shape has a single one.
    pub(crate) fn radius_mut(&mut self) -> Option<&mut Real> {
        match self {
            Self::Sphere { radius, .. }
            | Self::Cylinder { radius, .. }
            | Self::Cone { radius, .. }
            | Self::Sphereflake { radius, .. } => Some(radius),
            Self::Ellipsoid { .. } | Self::Paraboloid { .. } | Self::Plane { .. } => None,
        }
    }

    /// Returns true if the shape has a single radius.
    pub(crate) fn has_radius(mut self) -> bool {
        self.radius_mut().is_some()
    }

    /// Ratio of the classic sphereflake: 1/3.
    pub const FLAKE_RATIO: Real = Real::from_bits(0x5555_5555);

    /// Axes of an upright sphereflake: u = +x, v = -z, w = +y.
    pub const FLAKE_FRAME: [Vec3<Real>; 3] = [
        Vec3::new(Real::ONE, Real::ZERO, Real::ZERO),
        Vec3::new(Real::ZERO, Real::ZERO, Real::NEG_ONE),
        Vec3::new(Real::ZERO, Real::ONE, Real::ZERO),
    ];
}

/// Axis-aligned box in world coordinates that clips a plane. Low ends are below high ends.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ClipBox {
    /// Low and high end along x; `None` for an axis that is not clipped.
    pub x: Option<[Real; 2]>,
    /// Low and high end along y; `None` for an axis that is not clipped.
    pub y: Option<[Real; 2]>,
    /// Low and high end along z; `None` for an axis that is not clipped.
    pub z: Option<[Real; 2]>,
}

impl ClipBox {
    /// Box that clips nothing.
    pub const NONE: Self = Self {
        x: None,
        y: None,
        z: None,
    };
}
