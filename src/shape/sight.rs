use crate::Vec3;
use crate::num::Length;

/// A sphere or a plane as seen from a point, for any direction.
///
/// All eye rays start from one point, all shadow rays of a light from another:
/// what does not depend on their direction is computed once.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Sight {
    /// To the center of a sphere.
    pub(crate) to_center: Vec3<Length>,
    /// How deep in it the point is: for a sphere `r² - |to_center|²`, Q56; for
    /// a plane how far behind it, in steps of a [`Length`]. Below 0 outside.
    pub(crate) depth: i64,
}

impl Sight {
    /// Before it is computed.
    pub(crate) const NONE: Self = Self {
        to_center: Vec3::new(Length::ZERO, Length::ZERO, Length::ZERO),
        depth: 0,
    };
}
