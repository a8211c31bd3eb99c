use fixed::types::I8F56;

use super::bounding_sphere::BoundingSphere;
use super::low_precision::dot;
use crate::math::{
    Length, Square, Vec3, inverse_length_outlined, normalize, quotient, square_root,
};

/// The cone that the bounding sphere of an object fills as seen from a light: 12 bytes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LightCone {
    /// Unit vector from the center of the bounding sphere to the light: Q14.
    axis: Vec3<i16>,
    /// Index of the object.
    pub(crate) object: u16,
    /// Lower bound of the cosine between `axis` and the direction to the light of a ray that
    /// may hit the object: Q30.
    min_cosine: i32,
}

impl LightCone {
    /// A cone that contains every direction.
    pub(crate) const FULL: Self = Self {
        axis: Vec3::new(0, 0, 0),
        object: 0,
        min_cosine: 0,
    };

    /// Returns the cone of an object's bounding sphere from a near point: full if the point
    /// is inside the sphere.
    pub(crate) fn new(bound: &BoundingSphere, point: Vec3<Length>, object: u16) -> Self {
        /// More than the rounding of the two directions changes their cosine: 12.6 * 2^-16.
        const MARGIN: i32 = 13 << 14;
        let mut cone = Self {
            object,
            ..Self::FULL
        };
        let to_center = bound.center - point;
        let square = to_center.squared();
        let tangent_squared = square - bound.radius.square();
        if tangent_squared > 0 {
            // Q56 -> Q28
            let root = |square: I8F56| u64::from(square_root(square.to_bits() as u64));
            let cosine = quotient(root(tangent_squared).max(1), root(square)).to_bits();
            cone.min_cosine = cosine as i32 - MARGIN;
            // Q30 -> Q14, rounded
            let inverse = inverse_length_outlined(square.to_bits() as u64);
            let axis = -normalize(to_center.map(Length::to_bits), inverse);
            cone.axis = axis.map(|c| ((c.to_bits() + (1 << 15)) >> 16) as i16);
        }
        cone
    }

    /// Returns true if a ray whose direction to the light is `to_light`, Q16, may hit the
    /// object.
    #[inline(always)]
    pub(crate) fn may_contain(&self, to_light: Vec3<i32>) -> bool {
        dot(self.axis.map(i32::from), to_light) >= self.min_cosine
    }
}
