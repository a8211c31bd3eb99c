//! QEMU's mps2 boards, as far as firmware without a display needs them:
//! mps2-an385 (Cortex-M3, also with code for the M0), -an386 (M4F), -an500
//! (M7) and -an505 (M33).
//!
//! Firmware is told by semihosting what to draw, as its command line: size,
//! then file, `320x240 target/scene.bin`.

#![no_std]

mod blind;
mod host;
mod job;

pub use blind::Blind;
pub use host::{exit, print};
pub use job::{Failure, Job};

/// The core clock's period: 20 MHz on the an505, 25 MHz on the others.
pub const NANOSECONDS_PER_CLOCK: u32 = if cfg!(an505) { 50 } else { 40 };
