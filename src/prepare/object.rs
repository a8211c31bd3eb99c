use crate::archive::{Archive, Fields};
use crate::geometry::{Plane, Shape, SurfaceFlags, Texture};

/// A prepared shape and its texture, which take 112 bytes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Object {
    pub(crate) shape: Shape,
    pub(crate) texture: Texture,
    /// Flags that describe the shape, and flags that culling sets. Compiled scenes do not
    /// store this field, because decoding computes it.
    pub(crate) flags: SurfaceFlags,
}

impl Object {
    /// A placeholder object that no ray can hit.
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

    /// Replaces the shape and keeps the texture.
    pub(crate) fn set_shape(&mut self, shape: Shape) {
        *self = Self::new(shape, self.texture);
    }

    /// Returns true if every field is within its valid range. Tracing relies on these ranges.
    pub(crate) fn is_valid(&self, materials: u16) -> bool {
        self.shape.is_valid() && self.texture.is_valid(materials)
    }
}

impl Fields for Object {
    fn visit(&mut self, archive: &mut impl Archive) {
        self.shape.visit(archive);
        self.texture.visit(archive);
        self.flags = self.shape.flags();
    }
}
