use crate::math::Real;
use crate::scene::MaterialId;

/// Assignment of materials to the points of a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Texture {
    /// One material for all points.
    Uniform(MaterialId),
    /// Checkerboard in world coordinates: the first material where the sum of
    /// `floor(coordinate / size)` over both axes is even, the second material where it is odd.
    Checker {
        /// Side length of a cell, above 0.
        size: Real,
        /// Two different axes.
        axes: [Axis; 2],
        /// Materials of the even and the odd cells.
        materials: [MaterialId; 2],
    },
}

/// Axis of the right-handed world coordinate system.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Axis {
    /// The x axis, to the right.
    #[default]
    X,
    /// The y axis, up.
    Y,
    /// The z axis, toward the viewer.
    Z,
}
