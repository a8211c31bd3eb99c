use fixed::types::I8F56;

use super::bounding_sphere::BoundingSphere;
use super::low_precision::dot;
use crate::math::{
    Length, Square, Vec3, inverse_length_outlined, normalize, quotient, square_root,
};

/// The cone of directions in which a light sees the bounding sphere of an object. The cone
/// takes 12 bytes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LightCone {
    /// Unit vector from the center of the bounding sphere to the light, in Q14.
    axis: Vec3<i16>,
    /// Index of the object.
    pub(crate) object: u16,
    /// A shadow ray can hit the object only if the direction from the lit point to the light is
    /// close to `axis`. The cosine of the angle between them must be at least this value, which
    /// is in Q30.
    min_cosine: i32,
}

impl LightCone {
    /// A cone that contains every direction.
    pub(crate) const FULL: Self = Self {
        axis: Vec3::new(0, 0, 0),
        object: 0,
        min_cosine: 0,
    };

    /// Returns the cone in which the bounding sphere of an object is seen from `point`. The
    /// point must be in the near range (each coordinate within ±3.5). If the point is inside
    /// the sphere, the cone contains every direction.
    pub(crate) fn new(bound: &BoundingSphere, point: Vec3<Length>, object: u16) -> Self {
        /// Error margin: rounding the two directions changes their cosine by less than 12.6 *
        /// 2^-16.
        const MARGIN: i32 = 13 << 14;
        let mut cone = Self {
            object,
            ..Self::FULL
        };
        let to_center = bound.center - point;
        let square = to_center.squared();
        let tangent_squared = square - bound.radius.square();
        if tangent_squared > 0 {
            // The square has Q56, so its root has Q28.
            let root = |square: I8F56| u64::from(square_root(square.to_bits() as u64));
            let cosine = quotient(root(tangent_squared).max(1), root(square)).to_bits();
            cone.min_cosine = cosine as i32 - MARGIN;
            // The axis is rounded from Q30 to Q14.
            let inverse = inverse_length_outlined(square.to_bits() as u64);
            let axis = -normalize(to_center.map(Length::to_bits), inverse);
            cone.axis = axis.map(|c| ((c.to_bits() + (1 << 15)) >> 16) as i16);
        }
        cone
    }

    /// Returns true if a shadow ray may hit the object. `to_light` is the unit vector from the
    /// lit point to the light, in Q16.
    #[inline(always)]
    pub(crate) fn may_contain(&self, to_light: Vec3<i32>) -> bool {
        dot(self.axis.map(i32::from), to_light) >= self.min_cosine
    }
}
