use whitted::{Color, Real, Vec3};

/// Generates values from the bytes of a fuzz input. The bytes are followed by zeros.
pub(crate) struct Bytes<'a>(pub(crate) &'a [u8]);

impl Bytes<'_> {
    /// Returns the next byte; 0 after the end of the input.
    pub(crate) fn byte(&mut self) -> u8 {
        let Some((first, rest)) = self.0.split_first() else {
            return 0;
        };
        self.0 = rest;
        *first
    }

    /// Returns a number from 0 to `count - 1`.
    pub(crate) fn choice(&mut self, count: u8) -> u8 {
        self.byte() % count
    }

    /// Returns the next eight bytes as a big-endian number.
    fn word(&mut self) -> u64 {
        (0..8).fold(0, |word, _| word << 8 | u64::from(self.byte()))
    }

    /// Returns a number from `min` to `max`.
    ///
    /// Half of the returned numbers are an end of the range or its neighbor. The others
    /// have a random magnitude or are uniformly distributed.
    pub(crate) fn number(&mut self, min: Real, max: Real) -> Real {
        let (low, high) = (min.to_bits(), max.to_bits());
        let bits = match self.choice(8) {
            0 => low,
            1 => high,
            2 => low.saturating_add(1),
            3 => high.saturating_sub(1),
            // The shift selects the magnitude.
            4 | 5 => {
                let shift = self.byte() % 64;
                self.word() as i64 >> shift
            }
            _ => {
                let span = (high as u64).wrapping_sub(low as u64).max(1);
                low.wrapping_add((self.word() % span) as i64)
            }
        };
        Real::from_bits(bits.clamp(low, high))
    }

    /// Returns a number from `-max` to `max`, like [`number`](Self::number).
    pub(crate) fn signed(&mut self, max: Real) -> Real {
        self.number(-max, max)
    }

    /// Returns a point with coordinates from `-max` to `max`.
    pub(crate) fn point(&mut self, max: Real) -> Vec3<Real> {
        Vec3::new(self.signed(max), self.signed(max), self.signed(max))
    }

    /// Returns a color with channels from 0 to `max`; every third color is gray.
    pub(crate) fn color(&mut self, max: Real) -> Color<Real> {
        if self.choice(3) == 0 {
            return Color::gray(self.number(Real::ZERO, max));
        }
        let mut channel = || self.number(Real::ZERO, max);
        Color::new(channel(), channel(), channel())
    }
}
