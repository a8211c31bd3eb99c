//! Fuzz targets: functions that must return without a panic for any input.
//!
//! `cargo xtask prove fuzz` runs the targets under libFuzzer. `tests/fuzz` runs them on
//! stable Rust, with the inputs in `corpus` and random inputs. A new target needs a
//! function here, a file in `targets`, a `[[bin]]` in `Cargo.toml`, and a folder in
//! `corpus`.

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
