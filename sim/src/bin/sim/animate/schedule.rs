//! Times and durations of the frames of an animation.

use whitted::Real;

use crate::outcome::Outcome;

const DEFAULT_FPS: u16 = 20;

/// Largest number of frames of an animation. More frames would take days to render.
const MAX_FRAMES: i64 = 10_000;

/// Times of the frames of an animation, and the duration of one frame.
pub(super) struct Schedule {
    /// Time of each frame, in seconds from the start of the animation.
    pub(super) times: Vec<Real>,
    /// Duration of a frame in seconds.
    interval: Real,
    /// True if the animation repeats.
    pub(super) looping: bool,
}

impl Schedule {
    /// Creates the schedule of an animation from its duration in seconds, and from a frame rate and
    /// a number of frames, which are both optional.
    ///
    /// If the rate and the number are both given, the frames start at time 0 and may cover only a
    /// part of the animation. Otherwise, the frames cover the whole animation. In this case, the
    /// last frame of a looping animation is before its end, because the end looks like the start.
    /// The last of several frames of any other animation is at its end.
    pub(super) fn new(
        duration: Real,
        looping: bool,
        fps: Option<u16>,
        frames: Option<u16>,
    ) -> Outcome<Self> {
        let rate = Real::from(fps.unwrap_or(DEFAULT_FPS));
        let count = match frames {
            Some(frames) => frames.into(),
            None => rate.saturating_mul(duration).round().to_num::<i64>().max(1),
        };
        if count > MAX_FRAMES {
            let help = "use a smaller --frames or --fps";
            return Err(format!(
                "the animation would have {count} frames; the limit is {MAX_FRAMES}\n  help: {help}"
            )
            .into());
        }
        let fraction = |whole: Real, index: i64, count: i64| {
            let bits = i128::from(whole.to_bits()) * i128::from(index) / i128::from(count.max(1));
            Real::from_bits(bits as i64)
        };
        let time = |index| match (fps, frames) {
            (Some(_), Some(_)) => Real::from_num(index) / rate,
            _ if looping => fraction(duration, index, count),
            _ => fraction(duration, index, count - 1),
        };
        Ok(Self {
            times: (0..count).map(time).collect(),
            interval: match (fps, frames) {
                (Some(_), Some(_)) => Real::ONE / rate,
                _ => duration / Real::from_num(count),
            },
            looping,
        })
    }

    /// Returns the durations of the frames. The unit is 1/`per_second` of a second.
    ///
    /// A frame lasts from the end of the previous frame to its own end. These two times are rounded
    /// instead of the duration, so rounding errors do not add up.
    pub(super) fn delays(&self, per_second: u32) -> Vec<u64> {
        let end = |frames: usize| {
            to_units(
                self.interval.saturating_mul(Real::from_num(frames)),
                per_second,
            )
        };
        let frames = 0..self.times.len();
        frames.map(|frame| end(frame + 1) - end(frame)).collect()
    }
}

/// Converts seconds to units of 1/`per_second` of a second, and rounds to the nearest unit.
fn to_units(seconds: Real, per_second: u32) -> u64 {
    let twice = (i128::from(seconds.to_bits()) * i128::from(per_second)) >> 31;
    ((twice + 1) >> 1) as u64
}

#[cfg(test)]
mod tests {
    use super::*;

    fn times(looping: bool, fps: Option<u16>, frames: Option<u16>) -> Vec<String> {
        let schedule = Schedule::new(Real::from(4), looping, fps, frames);
        schedule.map_or_else(
            |error| vec![error.to_string()],
            |schedule| schedule.times.iter().map(Real::to_string).collect(),
        )
    }

    #[test]
    fn covers_the_whole_animation() {
        assert_eq!(times(true, None, Some(4)), ["0", "1", "2", "3"]);
        assert_eq!(times(false, None, Some(5)), ["0", "1", "2", "3", "4"]);
        assert_eq!(times(true, Some(1), None), ["0", "1", "2", "3"]);
        assert_eq!(times(true, None, None).len(), 80);
        assert_eq!(times(false, None, Some(1)), ["0"]);
    }

    #[test]
    fn rate_and_number_together_set_the_times() {
        assert_eq!(times(true, Some(2), Some(3)), ["0", "0.5", "1"]);
    }

    #[test]
    fn rounding_of_delays_does_not_add_up() -> Outcome {
        let schedule = Schedule::new(Real::from(4), true, Some(30), None)?;
        let delays = schedule.delays(100);
        assert_eq!(delays[..4], [3, 4, 3, 3]);
        assert_eq!(delays.iter().sum::<u64>(), 400);
        Ok(())
    }
}
