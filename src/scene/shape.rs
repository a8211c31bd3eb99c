use crate::math::{Real, Vec3};

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
    /// `x²/a² + y²/b² + z²/c² = 1`. Closed.
    Ellipsoid {
        /// Its center.
        center: Vec3<Real>,
        /// a, b and c, above 0; the longest at most 256 times the shortest.
        radii: Vec3<Real>,
    },
    /// `x² + z² = r²`. Open where it is clamped; an endless one bounds its inside.
    Cylinder {
        /// A point of the axis, from which `y` counts.
        origin: Vec3<Real>,
        /// Its radius, above 0.
        radius: Real,
        /// Where it begins and, above that, ends; `None` is endless.
        y: Option<[Real; 2]>,
    },
    /// `x² + z² = (r/h)² (y - h)²`: a circle of radius r at y = 0 and an apex at
    /// y = h. Open where it is clamped; an endless one bounds its inside.
    Cone {
        /// The center of the circle, from which `y` counts.
        origin: Vec3<Real>,
        /// The radius of the circle, above 0.
        radius: Real,
        /// Where the apex is: above 0, or below it for a cone that stands on
        /// its apex. 1/1024 to 1024 times the radius.
        height: Real,
        /// Where it begins and, above that, ends; beyond the apex it is a double cone.
        /// `None` is endless.
        y: Option<[Real; 2]>,
    },
    /// `x² + z² = y`, in world units. Open.
    Paraboloid {
        /// The vertex, from which `y` counts.
        origin: Vec3<Real>,
        /// Where it begins and, above that and above 0, ends.
        y: [Real; 2],
    },
    /// A plane, endless or bounded per axis. An endless one bounds the
    /// half-space behind its normal; a bounded one is open.
    Plane {
        /// Any length but 0.
        normal: Vec3<Real>,
        /// Any point of the plane.
        point: Vec3<Real>,
        /// Where it ends.
        bounds: ClipBox,
    },
    /// A sphere touched by twelve smaller ones, each of which is touched by
    /// twelve, and so on. Closed.
    Sphereflake {
        /// The center of the largest sphere.
        center: Vec3<Real>,
        /// Its radius, above 0.
        radius: Real,
        /// Generations of smaller spheres, 0 to 8. Six are 3,257,437 spheres.
        depth: u8,
        /// A sphere's radius in that of the one it touches: 0.1 to 0.5.
        ratio: Real,
        /// The directions u, v and w of the largest sphere, orthonormal.
        frame: [Vec3<Real>; 3],
    },
}

impl Shape {
    /// Where it is.
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

    /// Its radius, if it has one.
    pub(crate) fn radius_mut(&mut self) -> Option<&mut Real> {
        match self {
            Self::Sphere { radius, .. }
            | Self::Cylinder { radius, .. }
            | Self::Cone { radius, .. }
            | Self::Sphereflake { radius, .. } => Some(radius),
            Self::Ellipsoid { .. } | Self::Paraboloid { .. } | Self::Plane { .. } => None,
        }
    }

    /// Whether it has a radius.
    pub(crate) fn has_radius(mut self) -> bool {
        self.radius_mut().is_some()
    }

    /// The usual ratio of a sphereflake: 1/3.
    pub const FLAKE_RATIO: Real = Real::from_bits(0x5555_5555);

    /// The usual frame of a sphereflake, its poles up and down: u = +x, v = -z,
    /// w = +y.
    pub const FLAKE_FRAME: [Vec3<Real>; 3] = [
        Vec3::new(Real::ONE, Real::ZERO, Real::ZERO),
        Vec3::new(Real::ZERO, Real::ZERO, Real::NEG_ONE),
        Vec3::new(Real::ZERO, Real::ONE, Real::ZERO),
    ];
}

/// Bounds per axis in world coordinates: low ends, and high ends above them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ClipBox {
    /// Along x; `None` is endless.
    pub x: Option<[Real; 2]>,
    /// Along y.
    pub y: Option<[Real; 2]>,
    /// Along z.
    pub z: Option<[Real; 2]>,
}

impl ClipBox {
    /// Endless in every direction.
    pub const NONE: Self = Self {
        x: None,
        y: None,
        z: None,
    };
}
