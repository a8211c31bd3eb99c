//! Ordered dithering (Bayer 1973) with an 8x8 tile of thresholds.
//!
//! Random and blue-noise tiles of this size look coarser. Larger tiles repeat less often, but do
//! not have an exact mean over the small areas that the eye averages.

/// Threshold that rounds to the nearest level: half a level in Q16.
const HALF: u32 = 1 << 15;

/// Side of the tile in pixels, a power of two.
const SIDE: usize = 8;

/// Dithering of values between two levels of a display channel.
///
/// A value that equals a level is never changed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Dither {
    /// Selects the level below or above by an 8x8 pattern. The mean of any 8x8 pixels of one color
    /// is within 1/128 of a level of that color. Channels of 8 bits are rounded to the nearest
    /// level instead.
    #[default]
    Ordered,
    /// Rounds to the nearest level.
    Off,
}

impl Dither {
    /// Returns the threshold of pixel (x, y), which is added to a value before rounding down, in
    /// Q16 levels. `is_coarse` is true for channels of fewer than 8 bits.
    #[inline(always)]
    pub(crate) fn threshold(self, x: i32, y: i32, is_coarse: bool) -> u32 {
        match self {
            Self::Ordered if is_coarse => THRESHOLDS[y as usize % SIDE][x as usize % SIDE].into(),
            _ => HALF,
        }
    }
}

/// Rank of each pixel of the tile, 0 to 63: pixels of high rank reach the level above first.
///
/// The order is Bayer's, except that each four consecutive ranks, whose pixels are four apart,
/// are permuted. A ramp from black to white over 240 to 320 columns then keeps its mean in each
/// tile within one pixel of 64, even in black and white.
#[rustfmt::skip]
const ORDER: [[u8; SIDE]; SIDE] = [
    [0, 33, 10, 40, 3, 34, 9, 43],
    [48, 18, 56, 26, 51, 17, 59, 25],
    [14, 46, 6, 38, 13, 45, 5, 37],
    [60, 28, 54, 20, 63, 31, 53, 23],
    [2, 35, 8, 42, 1, 32, 11, 41],
    [50, 16, 58, 24, 49, 19, 57, 27],
    [12, 44, 4, 36, 15, 47, 7, 39],
    [62, 30, 52, 22, 61, 29, 55, 21],
];

/// Thresholds in Q16 levels: the centers of 64 equal parts of a level, ordered by `ORDER`.
static THRESHOLDS: [[u16; SIDE]; SIDE] = {
    let mut thresholds = [[0; SIDE]; SIDE];
    let mut index = 0;
    while index < SIDE * SIDE {
        let (x, y) = (index % SIDE, index / SIDE);
        thresholds[y][x] = 1024 * ORDER[y][x] as u16 + 512;
        index += 1;
    }
    thresholds
};
