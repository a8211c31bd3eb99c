//! Decodes the SPI traffic of a display driver into the picture on the display.
//!
//! Microcontroller emulators report the SPI bytes and the level of the D/C pin, but
//! have no display. A [`Controller`] executes these bytes as an ST7789 or ILI9341
//! does and returns the [`Picture`] that its [`Panel`] shows:
//!
//! ```
//! use display_stream::{Byte, Controller, Panel};
//!
//! let mut controller = Controller::new(Panel::ST7789_240X240);
//! let commands = [0x11, 0x21, 0x29, 0x3A]; // SLPOUT, INVON, DISPON, COLMOD
//! let mut stream = commands.map(Byte::Command).to_vec();
//! stream.extend([Byte::Data(0x55), Byte::Command(0x2C)]); // 16 bits; RAMWR
//! stream.extend([Byte::Data(0xF8), Byte::Data(0)].repeat(240 * 240)); // red
//! controller.receive_all(stream)?;
//! assert_eq!(controller.picture()?.pixels()[0].into_storage(), 0xF800);
//! # use embedded_graphics_core::prelude::IntoStorage;
//! # Ok::<(), Box<dyn core::error::Error>>(())
//! ```
//!
//! The model implements every command that the picture depends on, as the data
//! sheets specify it, and returns an error for traffic that no correct driver sends.
//! Manufacturer commands (0xB0 and above: voltages, timing, gamma) are ignored.

mod address;
mod command;
mod controller;
mod error;
mod memory;
mod panel;
mod picture;
mod pixel;

pub use controller::{Byte, Controller};
pub use error::{BlankError, StreamError};
pub use panel::Panel;
pub use picture::Picture;
