use crate::Vec3;
use crate::num::{Length, Square, Unit};
use crate::vector::high;

/// A sphere around all of a finite shape.
///
/// Most rays pass most shapes by. Whether one does is told by the high words
/// of a few products; what is left is looked at closely.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bound {
    pub(crate) center: Vec3<Length>,
    pub(crate) radius: Length,
}

impl Bound {
    /// How a near point sees it.
    pub(crate) fn seen_from(&self, point: Vec3<Length>) -> Sight {
        let to_center = self.center - point;
        let square = to_center.squared() - self.radius.square();
        Sight {
            to_center,
            least: (high(square.to_bits()) >> 4).saturating_sub(2),
        }
    }

    /// For rays from anywhere, of an object.
    pub(crate) fn around(&self, object: u16) -> Around {
        Around {
            center: self.center,
            radius: self.radius,
            reach: high(self.radius.square().to_bits()) + 4,
            object,
        }
    }
}

/// A bound as seen from a point where many rays start.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Sight {
    to_center: Vec3<Length>,
    /// Rays that come nearer to the center have at least this square of the
    /// way to where they are nearest: Q20, rounded down by what the high words
    /// leave out.
    least: i32,
}

impl Sight {
    /// Before it is computed.
    pub(crate) const NONE: Self = Self {
        to_center: Vec3::new(Length::ZERO, Length::ZERO, Length::ZERO),
        least: 0,
    };

    /// Whether the line of a ray may meet the shape.
    #[inline(always)]
    pub(crate) fn may_meet(&self, direction: Vec3<Unit>) -> bool {
        // Q58 -> Q26, whose square is Q52 -> Q20.
        let middle = high(self.to_center.along(direction).to_bits());
        high(middle.square()) >= self.least
    }
}

/// The bound of an object, for rays from anywhere.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Around {
    center: Vec3<Length>,
    radius: Length,
    /// The square of the radius: Q24, rounded up by what the high words leave out.
    reach: i32,
    /// The object's number.
    pub(crate) object: u16,
}

impl Around {
    /// The bound itself.
    pub(crate) fn bound(&self) -> Bound {
        Bound {
            center: self.center,
            radius: self.radius,
        }
    }

    /// Whether a ray from a near origin may meet the shape ahead.
    #[inline(always)]
    pub(crate) fn may_meet(&self, origin: Vec3<Length>, direction: Vec3<Unit>) -> bool {
        let to_center = self.center - origin;
        // Q58 -> Q28, whose square is Q56 -> Q24.
        let middle = (to_center.along(direction).to_bits() >> 30) as i32;
        let square = high(to_center.squared().to_bits());
        let nearest = if middle < 0 {
            square
        } else {
            square - high(middle.square())
        };
        nearest <= self.reach
    }
}
