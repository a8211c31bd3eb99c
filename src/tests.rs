//! Tests of the arithmetic and of each stage of tracing against exact results.

mod arithmetic;
mod error_bounds;
mod exact;
pub(crate) mod largest_error;
pub(crate) mod random;
