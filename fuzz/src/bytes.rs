use whitted::{Color, Real, Vec3};

/// Values out of bytes; zeros when they are used up.
pub(crate) struct Bytes<'a>(pub(crate) &'a [u8]);

impl Bytes<'_> {
    pub(crate) fn byte(&mut self) -> u8 {
        let Some((first, rest)) = self.0.split_first() else {
            return 0;
        };
        self.0 = rest;
        *first
    }

    /// 0 to `count - 1`.
    pub(crate) fn choice(&mut self, count: u8) -> u8 {
        self.byte() % count
    }

    fn word(&mut self) -> u64 {
        (0..8).fold(0, |word, _| word << 8 | u64::from(self.byte()))
    }

    /// A number of a range: often one of its ends or right beside, else of any
    /// magnitude.
    pub(crate) fn number(&mut self, least: Real, most: Real) -> Real {
        let (low, high) = (least.to_bits(), most.to_bits());
        let bits = match self.choice(8) {
            0 => low,
            1 => high,
            2 => low.saturating_add(1),
            3 => high.saturating_sub(1),
            // As far from zero as there are bits left by the shift.
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

    /// Like [`number`](Self::number), on either side of zero.
    pub(crate) fn signed(&mut self, most: Real) -> Real {
        self.number(-most, most)
    }

    pub(crate) fn point(&mut self, reach: Real) -> Vec3<Real> {
        Vec3::new(self.signed(reach), self.signed(reach), self.signed(reach))
    }

    pub(crate) fn color(&mut self, most: Real) -> Color<Real> {
        if self.choice(3) == 0 {
            return Color::gray(self.number(Real::ZERO, most));
        }
        let mut channel = || self.number(Real::ZERO, most);
        Color::new(channel(), channel(), channel())
    }
}
