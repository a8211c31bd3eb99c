use crate::math::Real;
use crate::scene::MaterialId;

/// Texture of a surface: it selects the material for each point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Texture {
    /// Every point has this material.
    Uniform(MaterialId),
    /// A checkerboard in world coordinates. For a point, `floor(coordinate / size)` is computed
    /// along each of the two axes. If the sum of the two values is even, the point has the first
    /// material, otherwise the second.
    Checker {
        /// Side length of a cell of the checkerboard, above 0.
        size: Real,
        /// The two axes along which the checkerboard varies. The two axes must differ.
        axes: [Axis; 2],
        /// The material of the even cells, then that of the odd cells.
        materials: [MaterialId; 2],
    },
}

/// An axis of the right-handed world coordinate system.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Axis {
    /// The x axis, which points to the right.
    #[default]
    X,
    /// The y axis, which points up.
    Y,
    /// The z axis, which points toward the viewer.
    Z,
}
