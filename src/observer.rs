//! Watching rays without paying for it when nobody does.

/// What kind of ray is traced.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RayKind {
    /// From the eye through a pixel.
    Eye,
    /// Mirrored at a surface.
    Reflected,
    /// Through a surface.
    Transmitted,
    /// Between a light and a surface.
    Shadow,
}

/// Is told of every ray and every intersection test.
///
/// The methods do nothing unless overridden, and `()` overrides none, so a
/// renderer without an observer has no code for it.
pub trait Observer {
    /// A ray is about to be traced.
    #[inline(always)]
    fn ray(&mut self, kind: RayKind) {
        let _ = kind;
    }

    /// A ray was tested against so many objects.
    #[inline(always)]
    fn intersections(&mut self, count: u32) {
        let _ = count;
    }
}

impl Observer for () {}

/// Counts rays by kind, and intersection tests.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Stats {
    /// Rays from the eye.
    pub eye: u32,
    /// Reflected rays.
    pub reflected: u32,
    /// Transmitted rays.
    pub transmitted: u32,
    /// Shadow rays.
    pub shadow: u32,
    /// Tests of a ray against an object.
    pub intersections: u64,
}

impl Observer for Stats {
    #[inline]
    fn ray(&mut self, kind: RayKind) {
        let counter = match kind {
            RayKind::Eye => &mut self.eye,
            RayKind::Reflected => &mut self.reflected,
            RayKind::Transmitted => &mut self.transmitted,
            RayKind::Shadow => &mut self.shadow,
        };
        *counter = counter.wrapping_add(1);
    }

    #[inline]
    fn intersections(&mut self, count: u32) {
        self.intersections = self.intersections.wrapping_add(count.into());
    }
}
