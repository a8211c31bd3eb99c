use crate::math::{Length, Square, Vec3};

/// A sphere that encloses a bounded shape.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BoundingSphere {
    pub(crate) center: Vec3<Length>,
    pub(crate) radius: Length,
}

impl BoundingSphere {
    /// Returns true if the gap between two spheres exceeds 0.00001. This margin is larger
    /// than the sum of all rounding errors.
    pub(crate) fn is_disjoint(&self, other: &Self) -> bool {
        const MARGIN: Length = Length::lit("0.00001");
        let reach = self.radius + other.radius + MARGIN;
        (self.center - other.center).squared() > reach.square()
    }
}
