//! Defines the pins and the display settings of the board.
//!
//! The values are for the Waveshare Pico-LCD-1.3 hat. README.md lists the pins in a table.
//! Change these values for another ST7789 display or for other buttons. The buttons must
//! connect their pins to ground.

use mipidsi::options::{ColorInversion, Orientation, Rotation};
use rp2040_hal::pac;

/// Width and height of the display, in pixels.
pub(crate) const LCD_SIZE: (u16, u16) = (240, 240);
/// The panel of the hat is mounted rotated by 90 degrees.
pub(crate) const LCD_ORIENTATION: Orientation = Orientation::new().rotate(Rotation::Deg90);
/// IPS panels need inverted colors.
pub(crate) const LCD_INVERSION: ColorInversion = ColorInversion::Inverted;
/// SPI clock of the display: 31.25 MHz. The ST7789 allows up to 62.5 MHz. Long wires need a
/// slower clock, for example 15.625 MHz.
pub(crate) const LCD_HZ: u32 = 31_250_000;

/// SPI peripheral that drives the clock and data pins of the display.
pub(crate) type LcdSpi = pac::SPI1;

/// Moves the peripheral [`LcdSpi`] out of `$peripherals`, the struct with all peripherals.
macro_rules! lcd_spi {
    ($peripherals:expr) => {
        $peripherals.SPI1
    };
}
pub(crate) use lcd_spi;

rp2040_hal::bsp_pins! {
    Gpio8 { name: lcd_dc }
    Gpio9 { name: lcd_cs }
    Gpio10 { name: lcd_clock, aliases: { FunctionSpi, PullDown: LcdClock } }
    Gpio11 { name: lcd_data, aliases: { FunctionSpi, PullDown: LcdData } }
    Gpio12 { name: lcd_reset }
    Gpio13 { name: lcd_backlight }
    Gpio2 { name: up }
    Gpio18 { name: down }
    Gpio16 { name: left }
    Gpio20 { name: right }
    Gpio15 { name: next }
    Gpio25 { name: led }
}
