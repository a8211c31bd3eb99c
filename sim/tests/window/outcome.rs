use std::error::Error;

/// Result of a test step.
pub(crate) type Outcome<T = ()> = Result<T, Box<dyn Error>>;
