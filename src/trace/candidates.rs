use heapless::Vec;

use super::intersect::Hit;

/// Capacity of the list of objects that may be visible on a scanline. If more objects may be
/// visible, the rays of the scanline are tested against all objects of the scene.
pub(crate) const MAX_CANDIDATES: usize = 64;

/// The objects that the camera rays of a scanline may hit.
#[derive(Clone, Debug, Default)]
pub(crate) struct Candidates {
    /// Indices of the objects that a camera ray may hit.
    pub(crate) objects: Vec<u16, MAX_CANDIDATES>,
    /// True if the list `objects` is complete. If the list is not complete, a ray may hit any
    /// object.
    pub(crate) is_complete: bool,
    /// True if all objects in the list are planes.
    pub(crate) are_planes: bool,
    /// True if the only object in the list is a plane, and all rays of the scanline reach this
    /// plane at the same distance. The unit of the distance is the length of a ray's direction,
    /// which is not normalized.
    pub(crate) is_coplanar: bool,
    /// The hit of an earlier ray of the scanline on the only plane in the list. It is stored only
    /// if `is_coplanar` is true. The current ray has the same distance to this plane. It hits the
    /// plane only if the hit point is inside the clip box of the plane.
    pub(crate) cached_hit: Option<Hit>,
    /// True if the most recent camera ray hit nothing. Tracing sets this field but never clears it,
    /// so pictures that do not need it do not pay for it.
    pub(crate) is_miss: bool,
}

impl Candidates {
    /// Returns the indices of the objects that the ray may hit. Returns `None` if the ray may
    /// hit any object.
    pub(crate) fn objects(&self) -> Option<&[u16]> {
        self.is_complete.then_some(&self.objects)
    }

    /// Caches a hit if its distance is also valid for the following rays of the scanline.
    pub(super) fn cache(&mut self, hit: Hit) {
        if self.is_coplanar && hit.is_near {
            self.cached_hit = Some(hit);
        }
    }
}
