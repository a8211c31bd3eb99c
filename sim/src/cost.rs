//! Estimates the time of a frame on a microcontroller.
//!
//! Every target draws the same bits, so the host can count what a frame needs: rays, intersection
//! tests, lights. [`Work`] counts them as an observer of the renderer. `prices.rs` has the
//! instructions for one of each on every core, fitted by `cargo xtask fit` to instruction counts
//! from QEMU. A [`Board`] turns instructions into seconds.

mod board;
mod prices;
mod work;

pub use board::{BOARDS, Board};
pub use prices::COUNTED;
pub use work::{ITEMS, Work};
