use crate::math::{Real, Vec3};

/// Surface of an object, in world units.
///
/// A surface is closed or open. A closed surface has an inside: a ray that passes through the
/// surface is refracted where it enters and where it leaves. An open surface has no inside. Shapes
/// with an axis of symmetry have this axis parallel to the y axis.
///
/// The documentation of each variant has an example.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Shape {
    /// A sphere. Its surface is closed.
    ///
    /// ```
    /// # use whitted::{Shape, real, vec3};
    /// let ball = Shape::Sphere { center: vec3!(0, 1, 0), radius: real!(1) };
    /// # let _ = ball;
    /// ```
    Sphere {
        /// Center of the sphere.
        center: Vec3<Real>,
        /// Radius of the sphere, above 0.
        radius: Real,
    },
    /// An ellipsoid `x²/a² + y²/b² + z²/c² = 1`. Its surface is closed.
    ///
    /// ```
    /// # use whitted::{Shape, vec3};
    /// let egg = Shape::Ellipsoid { center: vec3!(0, 1.2, 0), radii: vec3!(0.8, 1.2, 0.8) };
    /// # let _ = egg;
    /// ```
    Ellipsoid {
        /// Center of the ellipsoid.
        center: Vec3<Real>,
        /// Semi-axes a, b and c, all above 0. The longest may be at most 256 times the
        /// shortest.
        radii: Vec3<Real>,
    },
    /// A cylinder `x² + z² = r²` without caps. A cylinder that is clipped by `y` is open. An
    /// unbounded cylinder has an inside, so it is closed.
    ///
    /// ```
    /// # use whitted::{Shape, real, vec3};
    /// // A pipe on the floor, 2 units high.
    /// let pipe = Shape::Cylinder {
    ///     origin: vec3!(0, 0, 0),
    ///     radius: real!(0.5),
    ///     y: Some([real!(0), real!(2)]),
    /// };
    /// # let _ = pipe;
    /// ```
    Cylinder {
        /// A point on the axis. Heights `y` are relative to this point.
        origin: Vec3<Real>,
        /// Radius of the cylinder, above 0.
        radius: Real,
        /// Lowest and highest `y` of the cylinder. `None` makes the cylinder unbounded.
        y: Option<[Real; 2]>,
    },
    /// A double cone `x² + z² = (r/h)² (y - h)²` without caps. At y = 0 its radius is r, and the
    /// apex is at y = h. A double cone that is clipped by `y` is open. An unbounded double cone has
    /// an inside, so it is closed.
    ///
    /// ```
    /// # use whitted::{Shape, real, vec3};
    /// // A cone from the floor to its apex at a height of 2.
    /// let hat = Shape::Cone {
    ///     origin: vec3!(0, 0, 0),
    ///     radius: real!(1),
    ///     height: real!(2),
    ///     y: Some([real!(0), real!(2)]),
    /// };
    /// # let _ = hat;
    /// ```
    Cone {
        /// Point on the axis of the double cone at y = 0. All heights `y` are measured from this
        /// point.
        origin: Vec3<Real>,
        /// Radius r of the circle at y = 0, above 0.
        radius: Real,
        /// Height h of the apex above the circle at y = 0. If h is negative, the apex is below the
        /// circle. The absolute value of h is 1/1024 to 1024 times the radius.
        height: Real,
        /// Lowest and highest `y` of the double cone. They may lie on different sides of the apex.
        /// `None` makes the double cone unbounded.
        y: Option<[Real; 2]>,
    },
    /// A paraboloid `x² + z² = y`. Its surface is open.
    ///
    /// ```
    /// # use whitted::{Shape, real, vec3};
    /// // A bowl on the floor. At its rim, at a height of 1, the radius is 1.
    /// let bowl = Shape::Paraboloid { origin: vec3!(0, 0, 0), y: [real!(0), real!(1)] };
    /// # let _ = bowl;
    /// ```
    Paraboloid {
        /// Vertex of the paraboloid. Heights `y` are relative to this point.
        origin: Vec3<Real>,
        /// Lowest and highest `y` of the paraboloid. The highest `y` is above 0.
        y: [Real; 2],
    },
    /// A plane. An unbounded plane has an inside, the half-space behind the normal, so it is
    /// closed. A clipped plane is open.
    ///
    /// ```
    /// # use whitted::scene::ClipBox;
    /// # use whitted::{Shape, vec3};
    /// // An unbounded wall behind the scene.
    /// let wall = Shape::Plane {
    ///     normal: vec3!(0, 0, 1),
    ///     point: vec3!(0, 0, -3),
    ///     bounds: ClipBox::NONE,
    /// };
    /// # let _ = wall;
    /// ```
    Plane {
        /// Normal of the plane. The vector may have any length except 0.
        normal: Vec3<Real>,
        /// Any point of the plane.
        point: Vec3<Real>,
        /// Box in world coordinates that clips the plane.
        bounds: ClipBox,
    },
    /// A sphereflake. Twelve smaller spheres touch the largest sphere, twelve still smaller spheres
    /// touch each of these, and so on. The surface of a sphereflake is closed.
    ///
    /// ```
    /// # use whitted::{Shape, real, vec3};
    /// let flake = Shape::Sphereflake {
    ///     center: vec3!(0, 1, 0),
    ///     radius: real!(0.6),
    ///     depth: 4,
    ///     ratio: Shape::FLAKE_RATIO,
    ///     frame: Shape::FLAKE_FRAME,
    /// };
    /// # let _ = flake;
    /// ```
    Sphereflake {
        /// Center of the largest sphere.
        center: Vec3<Real>,
        /// Radius of the largest sphere, above 0.
        radius: Real,
        /// Number of generations of smaller spheres, 0 to 8. A sphereflake with six generations has
        /// 3,257,437 spheres.
        depth: u8,
        /// Ratio of a sphere's radius to the radius of its parent, 0.1 to 0.5.
        ratio: Real,
        /// Axes u, v and w of the largest sphere. They are a right-handed orthonormal basis.
        frame: [Vec3<Real>; 3],
    },
}

impl Shape {
    /// Returns the fields that animation tracks change: the position and the radius. The radius is
    /// `None` if the shape does not have exactly one radius.
    fn animated_fields(&mut self) -> (&mut Vec3<Real>, Option<&mut Real>) {
        match self {
            Self::Sphere { center, radius } => (center, Some(radius)),
            Self::Ellipsoid { center, .. } => (center, None),
            Self::Cylinder { origin, radius, .. } => (origin, Some(radius)),
            Self::Cone { origin, radius, .. } => (origin, Some(radius)),
            Self::Paraboloid { origin, .. } => (origin, None),
            Self::Plane { point, .. } => (point, None),
            Self::Sphereflake { center, radius, .. } => (center, Some(radius)),
        }
    }

    /// Returns the position of the shape. Animation tracks change this position.
    pub(crate) fn position_mut(&mut self) -> &mut Vec3<Real> {
        self.animated_fields().0
    }

    /// Returns the radius of the shape. Returns `None` if the shape does not have exactly one
    /// radius.
    pub(crate) fn radius_mut(&mut self) -> Option<&mut Real> {
        self.animated_fields().1
    }

    /// Returns true if the shape has exactly one radius.
    pub(crate) fn has_radius(mut self) -> bool {
        self.radius_mut().is_some()
    }

    /// Ratio of radii in the classic sphereflake: 1/3.
    pub const FLAKE_RATIO: Real = Real::from_bits(0x5555_5555);

    /// Axes of an upright sphereflake: u is +x, v is -z and w is +y.
    pub const FLAKE_FRAME: [Vec3<Real>; 3] = [
        Vec3::new(Real::ONE, Real::ZERO, Real::ZERO),
        Vec3::new(Real::ZERO, Real::ZERO, Real::NEG_ONE),
        Vec3::new(Real::ZERO, Real::ONE, Real::ZERO),
    ];
}

/// An axis-aligned box in world coordinates. It clips a plane. On each clipped axis, the low end is
/// below the high end.
///
/// ```
/// use whitted::scene::ClipBox;
/// use whitted::{Shape, real, vec3};
///
/// // A table top: 4 units wide, 2 units deep.
/// let table = Shape::Plane {
///     normal: vec3!(0, 1, 0),
///     point: vec3!(0, 1, 0),
///     bounds: ClipBox {
///         x: Some([real!(-2), real!(2)]),
///         z: Some([real!(-1), real!(1)]),
///         ..ClipBox::NONE
///     },
/// };
/// # let _ = table;
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ClipBox {
    /// Low and high end along the x axis. `None` if x is not clipped.
    pub x: Option<[Real; 2]>,
    /// Low and high end along the y axis. `None` if y is not clipped.
    pub y: Option<[Real; 2]>,
    /// Low and high end along the z axis. `None` if z is not clipped.
    pub z: Option<[Real; 2]>,
}

impl ClipBox {
    /// A box that clips nothing.
    pub const NONE: Self = Self {
        x: None,
        y: None,
        z: None,
    };
}
