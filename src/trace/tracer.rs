use crate::geometry::PrimitivePart;
use crate::prepare::PreparedScene;

/// Traces rays through a prepared scene.
///
/// The methods of the tracer are in the other files of this folder. Each file implements one
/// stage.
pub(crate) struct Tracer<'t, 's, O> {
    pub(crate) scene: &'s PreparedScene<'s>,
    /// The part of a composite shape that the last ray hit.
    pub(crate) part: &'t mut PrimitivePart,
    pub(crate) observer: &'t mut O,
}
