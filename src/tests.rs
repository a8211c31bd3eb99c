//! Tests of the arithmetic and of each stage of tracing against exact results.

mod arithmetic;
mod error_bounds;
mod exact;
mod largest_error;
mod random;
