use super::Keyframe;
use crate::geometry::Extent;
use crate::math::{Real, Vec3, divide, multiply};

/// Greatest rounding error of a point of a smooth segment: four units of 2^-32.
const ROUNDING: Real = Real::from_bits(4);

/// Slopes of a smooth segment are bounded by this value, 2^27, if its values are in range. A curve
/// with a steeper slope overshoots its keyframes by 4/27 of the slope, which is more than any valid
/// coordinate.
const STEEPEST: Real = Real::lit("134217728");

/// The interval between two consecutive keyframes that have different times.
pub(super) struct Segment {
    from: Keyframe,
    to: Keyframe,
    change: Vec3<Real>,
    /// Slopes at both ends, as the change of the value over the time of this segment. `None` if the
    /// segment is a straight line.
    slopes: Option<[Vec3<Real>; 2]>,
}

impl Segment {
    pub(super) fn linear(from: Keyframe, to: Keyframe) -> Self {
        Self {
            from,
            to,
            change: to.value.zip(from.value, Real::saturating_sub),
            slopes: None,
        }
    }

    /// Returns a segment of a spline. `before` and `after` are the keyframes next to the segment.
    pub(super) fn smooth(
        from: Keyframe,
        to: Keyframe,
        [before, after]: [Option<Keyframe>; 2],
    ) -> Self {
        let line = Self::linear(from, to);
        let first = before.and_then(|before| line.slope(&Self::linear(before, from)));
        let last = after.and_then(|after| line.slope(&Self::linear(to, after)));
        let slopes = match (first, last) {
            (Some(first), Some(last)) => Some([first, last]),
            (Some(first), None) => Some([first, line.opposite(first)]),
            (None, Some(last)) => Some([line.opposite(last), last]),
            (None, None) => None,
        };
        Self { slopes, ..line }
    }

    /// Returns the time between the keyframes.
    pub(super) fn span(&self) -> Real {
        self.to.time.saturating_sub(self.from.time)
    }

    /// Returns the value after the fraction `part` of this segment's time.
    pub(super) fn at(&self, part: Real) -> Vec3<Real> {
        let Some(cubics) = self.cubics() else {
            let moved = self.change.map(|c| multiply(c, part));
            return self.from.value.zip(moved, Real::saturating_add);
        };
        let moved = cubics.map(|cubic| cubic.at(part));
        let value = self.from.value.zip(moved, Real::saturating_add);
        let ends = self.from.value.zip(self.to.value, |from, to| (from, to));
        value.zip(ends, without_rounding)
    }

    /// Enlarges an extent to contain the values where the curve turns between its keyframes.
    pub(super) fn extend(&self, extent: &mut Extent) {
        let Some(cubics) = self.cubics() else { return };
        for turn in 0..2 {
            let turns = cubics.map(|cubic| cubic.turning_value(turn));
            for margin in [-ROUNDING, ROUNDING] {
                let value = self.from.value.zip(turns, |from, turn| {
                    turn.map_or(from, |turn| {
                        from.saturating_add(turn).saturating_add(margin)
                    })
                });
                extent.add_point(value.map(Real::to_bits));
            }
        }
        if !cubics.all(|cubic| cubic.is_in_range()) {
            extent.add_point(Vec3::new(i64::MIN, i64::MIN, i64::MIN));
        }
    }

    fn cubics(&self) -> Option<Vec3<Cubic>> {
        let [first, last] = self.slopes?;
        let slopes = first.zip(last, |first, last| (first, last));
        Some(self.change.zip(slopes, |change, (first, last)| Cubic {
            change,
            first,
            last,
        }))
    }

    /// Returns the slope of the spline at the keyframe that this segment shares with
    /// `neighbor`. It is the slope of a parabola through the keyframes of both segments. The
    /// slope is measured as the change of the value over the time of this segment. Returns
    /// `None` if the two keyframes of `neighbor` have the same time.
    fn slope(&self, neighbor: &Self) -> Option<Vec3<Real>> {
        let (span, other) = (self.span(), neighbor.span());
        if other == 0 {
            return None;
        }
        let weight = ratio(other, other.saturating_add(span));
        let stretch = multiply(ratio(span, other), Real::ONE - weight);
        Some(self.change.zip(neighbor.change, |change, other| {
            multiply(change, weight).saturating_add(multiply(other, stretch))
        }))
    }

    /// Returns the slope at one end of the segment if the curve is a parabola. The argument
    /// `slope` is the slope at the other end.
    fn opposite(&self, slope: Vec3<Real>) -> Vec3<Real> {
        self.change.zip(slope, |change, slope| {
            change.saturating_add(change).saturating_sub(slope)
        })
    }
}

/// One coordinate of a smooth segment: a cubic curve that begins at 0.
#[derive(Clone, Copy)]
struct Cubic {
    /// Value at the end of the curve.
    change: Real,
    /// Slope at the start.
    first: Real,
    /// Slope at the end.
    last: Real,
}

impl Cubic {
    /// Returns the coefficients of the square and the cube.
    fn bends(&self) -> [Real; 2] {
        // If the curve is a straight line, both slopes equal `change`, so both bends are zero.
        let first = self.change.saturating_sub(self.first);
        let last = self.change.saturating_sub(self.last);
        [
            first.saturating_add(first).saturating_add(last),
            first.saturating_add(last).saturating_neg(),
        ]
    }

    /// Returns the value after the fraction `part` of the segment's time. The result is exact at
    /// both ends.
    fn at(&self, part: Real) -> Real {
        let [square, cube] = self.bends();
        let bent = multiply(cube, part).saturating_add(square);
        let bent = multiply(bent, part).saturating_add(self.first);
        multiply(bent, part)
    }

    /// Returns true if no intermediate result of the curve saturates.
    fn is_in_range(&self) -> bool {
        [self.change, self.first, self.last]
            .into_iter()
            .all(|value| (-STEEPEST..=STEEPEST).contains(&value))
    }

    /// Returns the value at the first or second point where the curve turns, if there is such a
    /// point. `turn` is 0 or 1.
    ///
    /// The derivative is a parabola. On each side of its vertex, bisection finds the point where
    /// the derivative is zero.
    fn turning_value(&self, turn: u8) -> Option<Real> {
        if !self.is_in_range() {
            return None;
        }
        let [square, cube] = self.bends();
        let vertex = ratio(-square, cube * 3).clamp(Real::ZERO, Real::ONE);
        let [mut low, mut high] = match turn {
            0 => [Real::ZERO, vertex],
            _ => [vertex, Real::ONE],
        };
        let sign = self.slope_sign(low);
        if sign * self.slope_sign(high) >= 0 {
            return None;
        }
        while high - low > Real::DELTA {
            let middle = low + (high - low) / 2;
            if self.slope_sign(middle) == sign {
                low = middle;
            } else {
                high = middle;
            }
        }
        Some(self.at(high))
    }

    /// Returns the sign of the derivative after the fraction `part` of the segment's time.
    fn slope_sign(&self, part: Real) -> i128 {
        let [square, cube] = self.bends().map(|bend| i128::from(bend.to_bits()));
        let (first, part) = (i128::from(self.first.to_bits()), i128::from(part.to_bits()));
        let linear = ((2 * square) << 32) + 3 * cube * part;
        ((first << 64) + linear * part).signum()
    }
}

/// Moves a value to the nearest end of its segment if it is beyond that end by no more than a
/// rounding error. Otherwise, a value that stays within its range could leave it by rounding.
fn without_rounding(value: Real, (from, to): (Real, Real)) -> Real {
    let nearest = value.clamp(from.min(to), from.max(to));
    let distance = value.to_bits().abs_diff(nearest.to_bits());
    if distance <= ROUNDING.to_bits().unsigned_abs() {
        nearest
    } else {
        value
    }
}

/// Returns `dividend / divisor`, rounded toward zero and saturated. Returns 0 if `divisor` is
/// 0.
pub(super) fn ratio(dividend: Real, divisor: Real) -> Real {
    let quotient = divide(i128::from(dividend.to_bits()) << 32, divisor.to_bits());
    Real::from_bits(quotient.clamp(i64::MIN.into(), i64::MAX.into()) as i64)
}
