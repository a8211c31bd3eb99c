use std::error::Error;

/// What a command comes to. Each error names the file or the option.
pub(crate) type Outcome<T = ()> = Result<T, Box<dyn Error>>;
