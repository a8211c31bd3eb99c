use std::error::Error;

/// Result of a command. The message of an error names the file or option that caused the error.
pub(crate) type Outcome<T = ()> = Result<T, Box<dyn Error>>;
