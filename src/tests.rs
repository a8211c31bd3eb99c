//! Tests of the library's arithmetic against exact arithmetic.

mod error_bounds;
mod exact;
