//! Measurements that firmware prints about itself.
//!
//! Firmware draws a frame once and measures the drawing. It then traces the frame again for
//! its checksum, so that the checksum does not affect the measurement. A report consists of
//! `key: value` lines. On a UART, the line [`END`] ends the report.

#![no_std]

mod checksum;
mod frame;
mod memory;
mod stopwatch;

pub use checksum::Checksum;
pub use frame::{Report, draw};
pub use memory::peak_stack;
pub use stopwatch::Stopwatch;

/// Last line that firmware prints on a UART, after a report or an error.
pub const END: &str = "end";
