use crate::geometry::PrimitivePart;
use crate::prepare::PreparedScene;

/// Traces rays through a prepared scene.
///
/// The other files of this folder implement the methods of the tracer, one stage in each file.
pub(crate) struct Tracer<'t, 's, O> {
    pub(crate) scene: &'s PreparedScene<'s>,
    /// The part of a composite shape that the last ray hit.
    pub(crate) part: &'t mut PrimitivePart,
    pub(crate) observer: &'t mut O,
}
