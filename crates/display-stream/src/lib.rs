//! What a display shows that is sent a stream of commands and data.
//!
//! Emulators of microcontrollers tell what goes over their SPI, and how the D/C
//! pin stands meanwhile, but have no display. A [`Controller`] takes these bytes as
//! an ST7789 or ILI9341 does and gives the [`Picture`] on its [`Panel`]:
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
//! It does what the data sheets say of the commands that picture and state depend
//! on, and is stricter than they are: it refuses what no driver should send.
//! Commands of the makers (0xB0 and above: voltages, timing, gamma) are ignored.

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
