//! Size and times of the drawn frames.

use whitted::{Real, real};

/// Frame size in pixels.
pub(crate) const SIZE: [u32; 2] = [32, 24];

/// Returns the time of a frame, in seconds.
///
/// The frames are 0.0371 s apart and the animation takes 2 s, so the first 20,000 frames
/// all differ.
pub(crate) fn time(frame: u16) -> Real {
    const STEP: Real = real!(0.0371);
    STEP * Real::from(frame)
}
