//! Estimates the time of a frame on a microcontroller.
//!
//! Every target traces the same rays and draws the same bits, so the host can count the work for a
//! frame. [`Work`] observes the renderer and counts items such as rays, intersection tests and
//! lights. `prices.rs` has the price of each item on each core, in instructions; `cargo xtask fit`
//! fits the prices to instruction counts from QEMU. A [`Board`] converts instructions to seconds.

mod board;
mod prices;
mod work;

pub use board::{BOARDS, Board};
pub use prices::COUNTED;
pub use work::{ITEMS, Work};
