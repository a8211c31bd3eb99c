use crate::archive::{Archive, Fields};
use crate::geometry::{Plane, Shape, SurfaceFlags, Texture};

/// A shape and its texture: 112 bytes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Object {
    pub(crate) shape: Shape,
    pub(crate) texture: Texture,
    /// Flags of the shape, and flags found by culling. Derived.
    pub(crate) flags: SurfaceFlags,
}

impl Object {
    /// A placeholder that no ray hits.
    pub(crate) const NONE: Self = Self {
        shape: Shape::Plane(Plane::NONE),
        texture: Texture::Uniform(0),
        flags: SurfaceFlags::NONE,
    };

    pub(crate) fn new(shape: Shape, texture: Texture) -> Self {
        let flags = shape.flags();
        Self {
            shape,
            texture,
            flags,
        }
    }

    /// Returns true if every field is in the range that tracing relies on.
    #[inline(never)]
    pub(crate) fn is_valid(&self, materials: u16) -> bool {
        self.shape.is_valid() && self.texture.is_valid(materials)
    }
}

impl Fields for Object {
    #[inline(never)]
    fn visit(&mut self, archive: &mut impl Archive) {
        self.shape.visit(archive);
        self.texture.visit(archive);
        self.flags = self.shape.flags();
    }
}
