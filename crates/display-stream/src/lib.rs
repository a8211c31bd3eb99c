//! Decodes the bytes that a display driver sends over SPI into the picture on the display.
//!
//! Emulators of microcontrollers report the SPI bytes and the level of the D/C pin, but
//! have no display. A [`Controller`] executes these bytes as an ST7789 or ILI9341 does. It
//! returns the [`Picture`] that its [`Panel`] shows:
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
//! The model follows the data sheets and implements every standard command that changes the
//! picture. It returns an error for bytes that no correct driver sends. It ignores
//! manufacturer commands (0xB0 and above), which set voltages, timing and gamma.

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
