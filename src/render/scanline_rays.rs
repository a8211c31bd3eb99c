use crate::math::{Unit, Vec3, high};
use crate::render::column_range::ColumnRange;

/// Iterator over the directions of a scanline's camera rays.
///
/// The directions are not normalized. Their length is at most 7/8. Each direction is the previous
/// direction plus a constant vector in Q62. The rounding errors of these additions stay far below
/// 2^-30, the resolution of the returned directions.
#[derive(Clone, Debug)]
pub(crate) struct ScanlineRays {
    /// Next direction in Q62. Each component is increased by 2^-31, half the resolution of Q30.
    /// Truncating a component to Q30 therefore rounds it to nearest.
    direction: Vec3<i64>,
    step: Vec3<i64>,
    remaining: u32,
}

impl ScanlineRays {
    /// Returns an iterator over `count` directions. The first direction is `first`, and each
    /// further direction is the previous one plus `step`. Both vectors have Q62.
    pub(super) fn new(first: Vec3<i64>, step: Vec3<i64>, count: u32) -> Self {
        Self {
            direction: first.map(|c| c.wrapping_add(1 << 31)),
            step,
            remaining: count,
        }
    }

    /// Returns the next direction and the direction `count` rays after it. The second direction may
    /// lie beyond the end of the iterator.
    pub(super) fn ends(&self, count: i32) -> [Vec3<Unit>; 2] {
        [self.direction, offset(self.direction, &self.step, count)].map(to_unit)
    }

    /// Skips `count` rays.
    pub(super) fn skip_rays(&mut self, count: u32) {
        let steps = count.min(self.remaining) as i32;
        self.direction = offset(self.direction, &self.step, steps);
        self.remaining = self.remaining.saturating_sub(count);
    }

    /// Returns an iterator over the rays of the given columns. `self` must contain all rays of the
    /// scanline.
    pub(crate) fn through(mut self, columns: ColumnRange) -> Self {
        let ColumnRange { from, to, spacing } = columns;
        let to = to.min(self.remaining);
        if from > 0 {
            self.skip_rays(from);
        }
        let round_up = (1 << spacing) - 1;
        Self {
            step: offset(Vec3::new(0, 0, 0), &self.step, 1 << spacing),
            remaining: (to.saturating_sub(from) + round_up) >> spacing,
            ..self
        }
    }
}

impl Iterator for ScanlineRays {
    type Item = Vec3<Unit>;

    fn next(&mut self) -> Option<Vec3<Unit>> {
        self.remaining = self.remaining.checked_sub(1)?;
        let direction = to_unit(self.direction);
        self.direction = self.direction.zip(self.step, i64::wrapping_add);
        Some(direction)
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        (self.remaining as usize, Some(self.remaining as usize))
    }
}

/// Returns `direction + count * step`. The sum wraps around on overflow.
///
/// This function is not inlined, because it runs only a few times per scanline.
#[inline(never)]
pub(super) fn offset(direction: Vec3<i64>, step: &Vec3<i64>, count: i32) -> Vec3<i64> {
    direction.zip(*step, |d, s| d.wrapping_add(s.wrapping_mul(count.into())))
}

/// Truncates a direction from Q62 to Q30.
fn to_unit(direction: Vec3<i64>) -> Vec3<Unit> {
    direction.map(|c| Unit::from_bits(high(c)))
}
