use crate::math::Real;
use crate::scene::MaterialId;

/// Texture of a surface: it selects the material for each point.
///
/// ```
/// use whitted::scene::Axis;
/// use whitted::{MaterialId, Object, Texture, real};
///
/// // A floor with squares of 1 unit.
/// let squares = Texture::Checker {
///     size: real!(1),
///     axes: [Axis::X, Axis::Z],
///     materials: [MaterialId(0), MaterialId(1)],
/// };
/// let floor = Object::floor(real!(0), squares);
/// # let _ = floor;
/// ```
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
///
/// ```
/// use whitted::scene::Axis;
/// use whitted::{MaterialId, Texture, real};
///
/// // Squares on a wall that faces the viewer vary along x and y.
/// let tiles = Texture::Checker {
///     size: real!(0.5),
///     axes: [Axis::X, Axis::Y],
///     materials: [MaterialId(0), MaterialId(1)],
/// };
/// # let _ = tiles;
/// ```
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
