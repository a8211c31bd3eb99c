use heapless::Vec;

use super::intersect::Hit;

/// Capacity for the objects that a scanline may show. A scanline with more objects is traced
/// against all objects of the scene.
pub(crate) const MAX_CANDIDATES: usize = 64;

/// Objects that a camera ray may hit.
#[derive(Clone, Debug, Default)]
pub(crate) struct Candidates {
    /// Indices of the objects.
    pub(crate) objects: Vec<u16, MAX_CANDIDATES>,
    /// True if the list is complete. Otherwise the ray may hit any object.
    pub(crate) is_complete: bool,
    /// True if all objects are planes.
    pub(crate) are_planes: bool,
    /// True if the only object is a plane at the same distance, in lengths of the ray's
    /// unnormalized direction, for all rays of the scanline.
    pub(crate) is_coplanar: bool,
    /// Hit of an earlier ray on that plane. Its distance holds for this ray if the point is
    /// inside the plane's clip box.
    pub(crate) cached_hit: Option<Hit>,
}

impl Candidates {
    /// Indices of the objects; `None` if the ray may hit any object.
    #[inline(always)]
    pub(crate) fn objects(&self) -> Option<&[u16]> {
        self.is_complete.then_some(&self.objects)
    }

    /// Caches a hit if its distance holds for the following rays.
    #[inline(always)]
    pub(super) fn cache(&mut self, hit: Hit) {
        if self.is_coplanar && hit.is_near {
            self.cached_hit = Some(hit);
        }
    }
}
