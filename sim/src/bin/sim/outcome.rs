use std::error::Error;

/// Result of a command. Each error names the file or the option.
pub(crate) type Outcome<T = ()> = Result<T, Box<dyn Error>>;
