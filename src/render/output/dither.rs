//! Ordered dithering (Bayer 1973): a threshold for each pixel of a tile.
//!
//! Random and blue-noise tiles of that size look coarser, larger ones repeat
//! less but have no exact mean in a small box, which is what an eye sees.

/// Half a level: rounding to the nearest.
const HALF: u32 = 1 << 15;

/// The side of the tile, a power of two.
const SIDE: usize = 8;

/// What becomes of values between two levels of a display's channel.
///
/// Either way a value that has a level of its own is shown as that.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Dither {
    /// The level below or above, by a pattern of 8x8 pixels: the mean of any 8x8
    /// pixels of one color is within 1/128 of a level of it. Colors of 8 bits a
    /// channel are shown as if by [`Dither::Off`].
    #[default]
    Ordered,
    /// The nearest level.
    Off,
}

impl Dither {
    /// What is added to a value of pixel (x, y), in steps of 2^-16 of a level,
    /// before it is rounded down; `is_coarse` tells a channel of fewer than 8
    /// bits.
    #[inline(always)]
    pub(crate) fn threshold(self, x: i32, y: i32, is_coarse: bool) -> u32 {
        match self {
            Self::Ordered if is_coarse => THRESHOLDS[y as usize % SIDE][x as usize % SIDE].into(),
            _ => HALF,
        }
    }
}

/// Which pixel of a tile is the first to fall back to the level below.
///
/// Bayer's order, but for each four in a row, which are four pixels apart: they
/// take turns so that a ramp from black to white over 240 to 320 columns keeps
/// its mean in each tile to one pixel of 64, even in black and white.
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

/// The middles of 64 equal parts of a level, in that order.
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
