//! What the firmware tells about itself, the same for every board.
//!
//! A frame is drawn once and measured on its way to the display, then traced
//! again for its checksum, so that the checksum costs the measured frame
//! nothing. The report is lines of `key: value`, ended by the line [`END`].

#![no_std]

mod checksum;
mod frame;
mod memory;
mod stopwatch;

pub use checksum::Checksum;
pub use frame::{Report, draw};
pub use memory::peak_stack;
pub use stopwatch::Stopwatch;

/// The last line that firmware prints, whether it has drawn or failed.
pub const END: &str = "end";
