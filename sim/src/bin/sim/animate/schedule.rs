//! When frames are taken, and how long each is shown.

use whitted::Real;
use whitted_sim::scene_file::Motion;

use crate::outcome::Outcome;

const DEFAULT_FPS: u16 = 20;

/// More would be a mistake, and take days.
const MOST_FRAMES: i64 = 10_000;

/// The times of the frames.
pub(super) struct Schedule {
    /// When in the animation each frame is.
    pub(super) times: Vec<Real>,
    /// How long each is shown.
    interval: Real,
    /// Whether the film begins anew.
    pub(super) looping: bool,
}

impl Schedule {
    /// By one of the rate and the number of frames the whole animation is
    /// taken, by both as much of it as they say. A loop closes, and anything
    /// else ends at its end.
    pub(super) fn new(motion: &Motion, fps: Option<u16>, frames: Option<u16>) -> Outcome<Self> {
        let rate = Real::from(fps.unwrap_or(DEFAULT_FPS));
        let count = match frames {
            Some(frames) => frames.into(),
            None => rate
                .saturating_mul(motion.duration)
                .round()
                .to_num::<i64>()
                .max(1),
        };
        if count > MOST_FRAMES {
            let help = "choose fewer by --frames, or a lower --fps";
            return Err(format!(
                "the animation would be {count} frames, of at most {MOST_FRAMES}\n  help: {help}"
            )
            .into());
        }
        let part = |whole: Real, index: i64, of: i64| {
            let bits = i128::from(whole.to_bits()) * i128::from(index) / i128::from(of.max(1));
            Real::from_bits(bits as i64)
        };
        let time = |index| match (fps, frames) {
            (Some(_), Some(_)) => Real::from_num(index) / rate,
            _ if motion.looping => part(motion.duration, index, count),
            _ => part(motion.duration, index, count - 1),
        };
        Ok(Self {
            times: (0..count).map(time).collect(),
            interval: match (fps, frames) {
                (Some(_), Some(_)) => Real::ONE / rate,
                _ => motion.duration / Real::from_num(count),
            },
            looping: motion.looping,
        })
    }

    /// How long a frame is shown, in fractions of a second: roundings do not
    /// add up.
    pub(super) fn delay(&self, frame: usize, per_second: u32) -> u16 {
        let end =
            |frames: usize| super::in_units(self.interval * Real::from_num(frames), per_second);
        let delay = end(frame + 1) - end(frame);
        u16::try_from(delay).unwrap_or(u16::MAX)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn schedule(looping: bool, fps: Option<u16>, frames: Option<u16>) -> Vec<String> {
        let mut motion = Motion::once_around();
        motion.looping = looping;
        let schedule = Schedule::new(&motion, fps, frames);
        schedule.map_or_else(
            |error| vec![error.to_string()],
            |schedule| schedule.times.iter().map(Real::to_string).collect(),
        )
    }

    #[test]
    fn a_loop_closes_and_all_else_ends() {
        assert_eq!(schedule(true, None, Some(4)), ["0", "1", "2", "3"]);
        assert_eq!(schedule(false, None, Some(5)), ["0", "1", "2", "3", "4"]);
        assert_eq!(schedule(true, Some(1), None), ["0", "1", "2", "3"]);
        assert_eq!(schedule(true, None, None).len(), 80);
        assert_eq!(schedule(false, None, Some(1)), ["0"]);
    }

    #[test]
    fn a_rate_and_a_number_go_on() {
        assert_eq!(schedule(true, Some(2), Some(3)), ["0", "0.5", "1"]);
    }

    #[test]
    fn delays_do_not_drift() -> Outcome {
        let film = Schedule::new(&Motion::once_around(), Some(30), None)?;
        let delays: Vec<u16> = (0..120).map(|frame| film.delay(frame, 100)).collect();
        assert_eq!(delays[..4], [3, 4, 3, 3]);
        assert_eq!(delays.iter().sum::<u16>(), 400);
        Ok(())
    }
}
