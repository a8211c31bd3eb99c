//! Board support for QEMU's mps2 machines.
//!
//! The machines are mps2-an385 (Cortex-M3; also runs code for the M0), mps2-an386 (M4F),
//! mps2-an500 (M7) and mps2-an505 (M33). They have no display. Firmware reads its
//! job from the semihosting command line, for example `320x240 target/scene.bin`, and
//! prints its result by semihosting.

#![no_std]

mod host;
mod job;
mod null_display;

pub use host::{exit, print};
pub use job::{Job, JobError};
pub use null_display::NullDisplay;

/// Period of the core clock. The clock runs at 20 MHz on the mps2-an505 and at 25 MHz on
/// the other machines.
pub const NANOSECONDS_PER_CLOCK: u32 = if cfg!(an505) { 50 } else { 40 };
