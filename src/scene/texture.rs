use crate::math::Real;
use crate::scene::MaterialId;

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
