/// Number of rows and columns of the grid of sample positions in a pixel.
pub(super) const GRID: u32 = 8;

/// Greatest width and height of an antialiased picture in pixels. [`GRID`] times this number must
/// not exceed the greatest number of camera rays per side.
pub(super) const MAX_SIDE: u32 = crate::render::camera_rays::MAX_SIDE / GRID;

/// Number of additional rays for a pixel at an edge, besides the ray through its center.
///
/// The rays go through cells of an 8x8 grid and are spread evenly over the rows and columns of the
/// grid. The more columns and rows contain a ray, the more gray levels a nearly vertical or nearly
/// horizontal edge gets.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SampleCount {
    /// Four rays in a rotated square. No two of them share a row or a column.
    #[default]
    Four,
    /// Sixteen rays: two in each row and two in each column.
    Sixteen,
}

type Rows = [&'static [u32]; GRID as usize];

impl SampleCount {
    /// Returns, for each row of the grid, the columns of its rays in ascending order.
    pub(super) fn rows(self) -> &'static Rows {
        // These patterns were found by trial. Among point-symmetric patterns, their pictures came
        // closest to pictures with 256 rays per pixel.
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

    /// Returns the weight of each ray of a pixel at an edge. With n rays, including the center ray,
    /// the weight is `1 / n` in Q32, rounded up.
    pub(super) fn weight(self) -> u32 {
        const fn weight(samples: u64) -> u32 {
            (1_u64 << 32).div_ceil(samples) as u32
        }
        match self {
            Self::Four => const { weight(1 + 4) },
            Self::Sixteen => const { weight(1 + 16) },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn patterns_have_documented_counts_in_ascending_columns() {
        for (samples, count) in [(SampleCount::Four, 4), (SampleCount::Sixteen, 16)] {
            let rows = samples.rows();
            assert_eq!(rows.iter().map(|row| row.len()).sum::<usize>(), count);
            let rises = |row: &&[u32]| row.is_sorted_by(|a, b| a < b);
            assert!(rows.iter().all(rises));
            assert!(rows.iter().copied().flatten().all(|column| *column < GRID));
        }
    }
}
