use crate::geometry::PrimitivePart;
use crate::prepare::PreparedScene;

/// Traces rays through a prepared scene.
///
/// The operations are in the other files of this folder, one stage each.
pub(crate) struct Tracer<'t, 's, O> {
    pub(crate) scene: &'s PreparedScene<'s>,
    /// Part of a composite shape that the last ray hit.
    pub(crate) part: &'t mut PrimitivePart,
    pub(crate) observer: &'t mut O,
}
