//! The surface that a ray leaves.

/// Flags of an object that affect the rays leaving its surface.
///
/// Every ray carries a copy of the flags, so they are packed into two bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct SurfaceFlags(u16);

impl SurfaceFlags {
    pub(crate) const NONE: Self = Self(0);
    /// The object is convex: a ray that leaves the outside of the object cannot hit it again.
    pub(crate) const CONVEX: Self = Self(1);
    /// The object is flat: a ray that leaves either side of the object cannot hit it again.
    pub(crate) const FLAT: Self = Self(2);
    /// The object has a bounding sphere.
    pub(crate) const BOUNDED: Self = Self(4);
    /// The object has an open surface, which encloses nothing and does not refract light.
    pub(crate) const OPEN: Self = Self(8);
    /// The object is a transparent sphere, and no other object reaches into it.
    pub(crate) const ISOLATED: Self = Self(16);
    /// The normal is exactly +y, as on a floor.
    pub(crate) const HORIZONTAL: Self = Self(32);
    /// Nothing can come between the object and the first light. The next seven bits are the same
    /// flags for the next seven lights.
    const UNOCCLUDED: Self = Self(256);

    /// Returns the flag which means that nothing can come between an object and the light with the
    /// index `light`. Only the first eight lights have such a flag. For other lights, the result is
    /// [`Self::NONE`].
    pub(crate) fn unoccluded_from(light: usize) -> Self {
        if light < 8 {
            Self(Self::UNOCCLUDED.0 << light)
        } else {
            Self::NONE
        }
    }

    /// Returns these flags. If `condition` holds, the result also contains the flags in `other`.
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

/// The surface that a ray leaves.
///
/// A secondary ray starts only approximately on the surface that it leaves. The ray may therefore
/// seem to hit that surface again, very close to its origin. Many ray tracers ignore hits closer
/// than a small constant, but no constant suits every scene. In this library, a ray stores the
/// object that it leaves. For that object, the root `t = 0` of the equation is the origin of the
/// ray and not a hit.
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
