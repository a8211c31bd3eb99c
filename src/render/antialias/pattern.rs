/// The side of the grid of places in a pixel that rays may go through.
pub(super) const GRID: u32 = 8;

/// The longest side of a picture, of which the fine one is within what a view may have.
pub(super) const MAX_SIDE: u32 = crate::render::camera_rays::MAX_SIDE / GRID;

/// How many more rays go through a pixel at an edge, beside the one through its
/// center.
///
/// They lie at centers of an 8x8 grid, spread over its rows and columns: an edge
/// that is nearly upright or level shows as many steps as there are of those.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SampleCount {
    /// A rotated square, each in a row and a column of its own.
    #[default]
    Four,
    /// Two in each row and each column.
    Sixteen,
}

type Rows = [&'static [u32]; GRID as usize];

impl SampleCount {
    /// The columns of the grid in each of its rows.
    pub(super) fn rows(self) -> &'static Rows {
        // Of the patterns that are their own mirror at the center, those that
        // came closest to 256 rays a pixel, by trial.
        const FOUR: Rows = [&[2], &[], &[7], &[], &[], &[0], &[], &[5]];
        const SIXTEEN: Rows = [
            &[1, 4],
            &[3, 6],
            &[0, 5],
            &[2, 7],
            &[0, 5],
            &[2, 7],
            &[1, 4],
            &[3, 6],
        ];
        match self {
            Self::Four => &FOUR,
            Self::Sixteen => &SIXTEEN,
        }
    }

    /// `2^32 / n` for all the rays of a pixel, rounded up.
    pub(super) fn share(self) -> u32 {
        const fn share(samples: u64) -> u32 {
            (1_u64 << 32).div_ceil(samples) as u32
        }
        match self {
            Self::Four => const { share(1 + 4) },
            Self::Sixteen => const { share(1 + 16) },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_have_as_many_places_as_promised_in_rising_order() {
        for (samples, count) in [(SampleCount::Four, 4), (SampleCount::Sixteen, 16)] {
            let rows = samples.rows();
            assert_eq!(rows.iter().map(|row| row.len()).sum::<usize>(), count);
            let rises = |row: &&[u32]| row.is_sorted_by(|a, b| a < b);
            assert!(rows.iter().all(rises));
            assert!(rows.iter().copied().flatten().all(|column| *column < GRID));
        }
    }
}
