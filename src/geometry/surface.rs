//! The surface that a ray leaves.

/// Flags of an object that rays which leave its surface depend on.
///
/// Every ray carries a copy, so the set is two bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct SurfaceFlags(u16);

impl SurfaceFlags {
    pub(crate) const NONE: Self = Self(0);
    /// A ray that leaves on the outside cannot hit the object again: it is convex.
    pub(crate) const CONVEX: Self = Self(1);
    /// A ray that leaves on either side cannot hit the object again: it is flat.
    pub(crate) const FLAT: Self = Self(2);
    /// The object has a bounding sphere.
    pub(crate) const BOUNDED: Self = Self(4);
    /// The surface is open: it encloses nothing and does not refract.
    pub(crate) const OPEN: Self = Self(8);
    /// A transparent sphere that no other object reaches into.
    pub(crate) const ISOLATED: Self = Self(16);
    /// The normal is exactly +y: a floor.
    pub(crate) const HORIZONTAL: Self = Self(32);
    /// Nothing can occlude the object from the first light. The seven bits above stand for
    /// the seven lights after it.
    const UNOCCLUDED: Self = Self(256);

    /// Flag of objects that nothing can occlude from a light; empty from the ninth light on.
    pub(crate) fn unoccluded_from(light: usize) -> Self {
        if light < 8 {
            Self(Self::UNOCCLUDED.0 << light)
        } else {
            Self::NONE
        }
    }

    /// Returns the union with the other flags if the condition holds, else these flags.
    pub(crate) fn with(self, other: Self, condition: bool) -> Self {
        if condition {
            Self(self.0 | other.0)
        } else {
            self
        }
    }

    /// Returns true if both sets have a flag in common.
    #[inline(always)]
    pub(crate) fn intersects(self, other: Self) -> bool {
        self.0 & other.0 != 0
    }
}

/// The surface that a ray leaves, in place of an epsilon.
///
/// The origin of a secondary ray lies only approximately on its surface, so a hit of that
/// surface cannot be distinguished from the origin by its distance: any epsilon is too small
/// for one scene and too large for another. A ray therefore knows the object that it leaves,
/// and the root `t = 0` of that object is known to be the origin.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct OriginSurface {
    /// Index of the object; `u16::MAX` for none.
    pub(crate) object: u16,
    /// The object if the ray cannot hit it again, else `u16::MAX`.
    pub(crate) skipped: u16,
    /// Sphere of a sphereflake, as its node path; else 0.
    pub(crate) part: u32,
    /// True if the ray runs through the inside of the object.
    pub(crate) is_inside: bool,
    pub(crate) flags: SurfaceFlags,
}

impl OriginSurface {
    /// No surface: the ray starts at the eye or at a light.
    pub(crate) const NONE: Self = Self {
        object: u16::MAX,
        skipped: u16::MAX,
        part: 0,
        is_inside: false,
        flags: SurfaceFlags::NONE,
    };

    #[inline(always)]
    pub(crate) fn new(object: u16, part: u32, is_inside: bool, flags: SurfaceFlags) -> Self {
        let cannot_return = flags.intersects(if is_inside {
            SurfaceFlags::FLAT
        } else {
            SurfaceFlags::CONVEX
        });
        let skipped = if cannot_return {
            object
        } else {
            Self::NONE.object
        };
        Self {
            object,
            skipped,
            part,
            is_inside,
            flags,
        }
    }

    /// Returns the other side of this surface: the origin of a transmitted ray.
    pub(crate) fn other_side(self) -> Self {
        Self::new(self.object, self.part, !self.is_inside, self.flags)
    }
}
