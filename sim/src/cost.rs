//! What a frame will take on a microcontroller, without having one.
//!
//! ```text
//! Renderer ── Work (an Observer) ──> amounts ── Model ──> instructions ── Board ──> seconds
//! ```
//!
//! The renderer does the same on every target, bit by bit, so this machine can
//! count what a frame asks for: rays, tests, hits. A core takes so many
//! instructions for each, which `cargo xtask fit` has found from frames whose
//! instructions QEMU counted, and which `sim/cost.toml` keeps. Cycles are those
//! instructions times an average from the core's manual: an estimate.

mod board;
mod model;
mod work;

pub use board::{BOARDS, Board};
pub use model::{Core, Model};
pub use work::{ITEMS, Item, Work};
