//! Which frames are drawn.

use whitted::Real;

/// Their size.
pub(crate) const SIZE: [u32; 2] = [32, 24];

/// When a frame is. The animation takes 2 s, so none is seen twice among 20,000.
pub(crate) fn time(frame: u16) -> Real {
    const STEP: Real = Real::lit("0.0371");
    STEP * Real::from(frame)
}
