//! Opcodes of the display commands that the model supports. The opcodes are from the MIPI
//! Display Command Set.

pub(crate) const NOP: u8 = 0x00;
pub(crate) const SWRESET: u8 = 0x01;
pub(crate) const SLPIN: u8 = 0x10;
pub(crate) const SLPOUT: u8 = 0x11;
pub(crate) const NORON: u8 = 0x13;
pub(crate) const INVOFF: u8 = 0x20;
pub(crate) const INVON: u8 = 0x21;
pub(crate) const GAMSET: u8 = 0x26;
pub(crate) const DISPOFF: u8 = 0x28;
pub(crate) const DISPON: u8 = 0x29;
pub(crate) const CASET: u8 = 0x2A;
pub(crate) const RASET: u8 = 0x2B;
pub(crate) const RAMWR: u8 = 0x2C;
pub(crate) const TEOFF: u8 = 0x34;
pub(crate) const TEON: u8 = 0x35;
pub(crate) const MADCTL: u8 = 0x36;
pub(crate) const IDMOFF: u8 = 0x38;
pub(crate) const COLMOD: u8 = 0x3A;
pub(crate) const RAMWRC: u8 = 0x3C;
pub(crate) const STE: u8 = 0x44;
// These commands set the brightness and the backlight. The model accepts but ignores them.
pub(crate) const WRDISBV: u8 = 0x51;
pub(crate) const WRCTRLD: u8 = 0x53;
pub(crate) const WRCACE: u8 = 0x55;
pub(crate) const WRCABCMB: u8 = 0x5E;

/// Lowest opcode of the manufacturer-specific commands. The model ignores these commands.
pub(crate) const FIRST_MANUFACTURER: u8 = 0xB0;

/// Returns the number of parameter bytes that the model reads for a command.
pub(crate) const fn parameter_count(command: u8) -> usize {
    match command {
        CASET | RASET => 4,
        MADCTL | COLMOD => 1,
        _ => 0,
    }
}
