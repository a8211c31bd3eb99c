//! What is wired to which pin, and how it is mounted: here alone.
//!
//! These are the pins of the hat Waveshare Pico-LCD-1.3. README.md has them as
//! a table; any ST7789 and buttons to ground can be wired so, or otherwise.

use mipidsi::options::{ColorInversion, Orientation, Rotation};
use rp2040_hal::pac;

/// In pixels, as they are read.
pub(crate) const LCD_SIZE: (u16, u16) = (240, 240);
/// The hat's panel is mounted on its side.
pub(crate) const LCD_ORIENTATION: Orientation = Orientation::new().rotate(Rotation::Deg90);
/// As an IPS panel needs it.
pub(crate) const LCD_INVERSION: ColorInversion = ColorInversion::Inverted;
/// The controller takes up to 62.5 MHz; halve it for long wires.
pub(crate) const LCD_HZ: u32 = 31_250_000;

/// The SPI that the pins of clock and data belong to.
pub(crate) type LcdSpi = pac::SPI1;

/// The same, of the chip's peripherals.
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
