//! Errors as text.

use core::fmt::{self, Display, Write};
use core::hint::black_box;

/// Takes text, or fails.
struct Paper;

impl Write for Paper {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        black_box(text);
        if black_box(false) {
            Err(fmt::Error)
        } else {
            Ok(())
        }
    }
}

pub(crate) fn print(text: &dyn Display) {
    black_box(write!(Paper, "{text}").is_ok());
}
