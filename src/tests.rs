//! Compares the results of the arithmetic and of each stage of tracing with exact results.

mod arithmetic;
mod error_bounds;
mod exact;
pub(crate) mod largest_error;
pub(crate) mod random;
