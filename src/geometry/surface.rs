//! The surface that a ray leaves.

/// Flags of an object that affect the rays leaving its surface.
///
/// Every ray carries a copy of the flags, so they are packed into two bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct SurfaceFlags(u16);

impl SurfaceFlags {
    pub(crate) const NONE: Self = Self(0);
    /// The object is convex: a ray that leaves its outside cannot hit it again.
    pub(crate) const CONVEX: Self = Self(1);
    /// The object is flat: a ray that leaves either side cannot hit it again.
    pub(crate) const FLAT: Self = Self(2);
    /// The object has a bounding sphere.
    pub(crate) const BOUNDED: Self = Self(4);
    /// The surface is open: it encloses nothing and does not refract.
    pub(crate) const OPEN: Self = Self(8);
    /// The object is a transparent sphere, and no other object reaches into it.
    pub(crate) const ISOLATED: Self = Self(16);
    /// The normal is exactly +y, as on a floor.
    pub(crate) const HORIZONTAL: Self = Self(32);
    /// Nothing can occlude the object from the first light. The next seven bits are the flags
    /// of the next seven lights.
    const UNOCCLUDED: Self = Self(256);

    /// Returns the flag that marks objects which nothing can occlude from a light. The set is
    /// empty from the ninth light on.
    pub(crate) fn unoccluded_from(light: usize) -> Self {
        if light < 8 {
            Self(Self::UNOCCLUDED.0 << light)
        } else {
            Self::NONE
        }
    }

    /// Returns these flags, and adds the `other` flags if the condition holds.
    pub(crate) fn with(self, other: Self, condition: bool) -> Self {
        if condition {
            Self(self.0 | other.0)
        } else {
            self
        }
    }

    /// Returns true if both sets have a flag in common.
    pub(crate) fn intersects(self, other: Self) -> bool {
        self.0 & other.0 != 0
    }
}

/// The surface that a ray leaves, stored with the ray instead of an epsilon.
///
/// The origin of a secondary ray lies only approximately on its surface, so a hit of that
/// surface cannot be distinguished from the origin by its distance: any epsilon is too small
/// for one scene and too large for another. A ray therefore stores the object that it leaves.
/// The test of that object then takes the root `t = 0` as the origin, not as a hit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct OriginSurface {
    /// Index of the object, or `u16::MAX` if the ray leaves no surface.
    pub(crate) object: u16,
    /// Index of the object if the ray cannot hit that object again, else `u16::MAX`.
    pub(crate) skipped: u16,
    /// Node path of the sphere if the object is a sphereflake, else 0.
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

    /// Returns the other side of this surface. Transmitted rays leave that side.
    pub(crate) fn other_side(self) -> Self {
        Self::new(self.object, self.part, !self.is_inside, self.flags)
    }
}
