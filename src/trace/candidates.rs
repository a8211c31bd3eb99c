use heapless::Vec;

use crate::trace::intersect::Hit;

/// More objects than these in one line are not told apart.
pub(crate) const MOST: usize = 64;

/// What a ray may meet.
#[derive(Clone, Debug, Default)]
pub(crate) struct Candidates {
    /// The numbers of the objects.
    pub(crate) objects: Vec<u16, MOST>,
    /// Whether these are all.
    pub(crate) are_complete: bool,
    /// Whether they are all planes.
    pub(crate) are_flat: bool,
    /// Whether that is a single plane that all rays approach alike.
    pub(crate) are_level: bool,
    /// Where a ray before this one met it: near, and as far away for this one, if the plane
    /// reaches there.
    pub(crate) met: Option<Hit>,
}

impl Candidates {
    /// The numbers of the objects; `None` if that may be any.
    #[inline(always)]
    pub(crate) fn objects(&self) -> Option<&[u16]> {
        self.are_complete.then_some(&self.objects)
    }

    /// Keeps a hit for the rays after this one, if it is as far away for them.
    #[inline(always)]
    pub(crate) fn keep(&mut self, hit: Hit) {
        if self.are_level && hit.is_near {
            self.met = Some(hit);
        }
    }
}
