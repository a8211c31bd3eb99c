//! Estimates the time of a frame on a microcontroller.
//!
//! Every target traces the same rays, so the host can count the work for a frame. [`Work`] observes
//! the renderer and counts items of work, such as rays, intersection tests and lights. The price of
//! an item is its number of instructions on a core. `prices.rs` has the prices, which `cargo xtask
//! fit` fits to instruction counts from QEMU. A [`Board`] converts instructions to seconds.

mod board;
mod prices;
mod work;

pub use board::{BOARDS, Board};
pub use prices::COUNTED;
pub use work::{ITEMS, Work};
