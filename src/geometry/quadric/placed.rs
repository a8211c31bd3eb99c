use super::super::normalization::Normalization;
use crate::math::{Length, Real, Vec3};

/// The form of a quadric and its place in the prepared scene.
pub(in super::super) struct Placed<F> {
    pub(super) center: Vec3<Length>,
    pub(super) clamp: Option<[Length; 2]>,
    pub(super) form: F,
}

impl<F> Placed<F> {
    /// Places a form that is clamped to the interval `y` above `origin`.
    ///
    /// The center of the quadric is put in the middle of the interval, so an interval far from
    /// `origin` loses no precision.
    #[inline(never)]
    pub(super) fn clamped(
        origin: Vec3<Real>,
        y: [Real; 2],
        normalization: &Normalization,
        form: F,
    ) -> Self {
        let above = |y: Real| Vec3 {
            y: origin.y + y,
            ..origin
        };
        Self {
            center: normalization.point(above(middle(y))),
            clamp: Some(y.map(|y| normalization.point(above(y)).y)),
            form,
        }
    }
}

/// Returns the middle of an interval, rounded down.
pub(super) fn middle([low, high]: [Real; 2]) -> Real {
    Real::from_bits((low.to_bits() + high.to_bits()) >> 1)
}
