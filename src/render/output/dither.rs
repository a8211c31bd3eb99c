//! Ordered dithering (Bayer 1973) with an 8x8 tile of thresholds.
//!
//! An 8x8 tile of random or blue noise looks coarser than this tile. Larger tiles repeat less
//! often, but the eye averages small areas, over which the mean of a larger tile is not exact.

/// Threshold that rounds a value to the nearest level: half a level in Q16.
const HALF: u32 = 1 << 15;

/// Width and height of the tile of thresholds, in pixels. The number must be a power of two.
const SIDE: usize = 8;

/// Dithering of values that lie between two levels of a display channel.
///
/// Dithering does not change a value that equals a level.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Dither {
    /// Ordered dithering: an 8x8 pattern decides whether a pixel gets the level below its value or
    /// the level above. In an area of uniform color, the mean of any 8x8 pixels differs from the
    /// color by at most 1/128 of a level. Channels of 8 bits are not dithered, but rounded to the
    /// nearest level.
    #[default]
    Ordered,
    /// Rounds values to the nearest level.
    Off,
}

impl Dither {
    /// Returns the threshold of pixel (x, y). The threshold is a fraction of a level, in Q16, that
    /// is added to a value before the value is rounded down. `is_coarse` must be true for channels
    /// of fewer than 8 bits.
    #[inline(always)]
    pub(crate) fn threshold(self, x: i32, y: i32, is_coarse: bool) -> u32 {
        match self {
            Self::Ordered if is_coarse => THRESHOLDS[y as usize % SIDE][x as usize % SIDE].into(),
            _ => HALF,
        }
    }
}

/// Rank of each pixel of the tile, from 0 to 63. As a value rises from one level to the next,
/// pixels of high rank switch to the next level first.
///
/// The order is Bayer's with one change. The pixels of four consecutive ranks are four columns or
/// rows apart. Within each such group of four pixels, the ranks are permuted. The change improves
/// ramps from black to white over 240 to 320 columns. Even on a black-and-white display, the mean
/// of each tile then differs from the ramp by at most one pixel of 64.
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

/// Threshold of each pixel of the tile, in Q16. A level is divided into 64 equal parts; the
/// threshold is the center of the part whose number is the pixel's rank in `ORDER`.
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
