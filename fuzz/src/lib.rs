//! What is fuzzed: functions of any bytes that must return.
//!
//! `cargo xtask prove fuzz` runs them under libFuzzer, `tests/fuzz` on stable:
//! on the inputs in `corpus` and on random ones. A target more is a function
//! here, a file in `targets`, a `[[bin]]`, and a folder in `corpus`.

mod bytes;
mod compiled;
mod display_stream;
mod extremes;
mod oracle;
mod picture;
mod scene_text;
mod serial;

pub use compiled::compiled;
pub use display_stream::display_stream;
pub use extremes::extremes;
pub use oracle::oracle;
pub use scene_text::scene_text;
pub use serial::serial;
