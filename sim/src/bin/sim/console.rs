use std::io::{self, ErrorKind, Write};
use std::path::Path;

use whitted_sim::text::escaped_lines;

use crate::output::is_stdout;

/// Stream for the messages of a command. Everything that the program prints goes through this type,
/// because `println!` panics if the reader of a pipe has gone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Console {
    Stdout,
    Stderr,
}

impl Console {
    /// Returns stdout, or stderr if the command writes its output to stdout.
    pub(crate) fn beside(output: &Path) -> Self {
        match is_stdout(output) {
            true => Self::Stderr,
            false => Self::Stdout,
        }
    }

    /// Writes bytes that may control the terminal, such as a picture.
    pub(crate) fn write_control(self, bytes: &[u8]) -> io::Result<()> {
        named(match self {
            Self::Stdout => io::stdout().write_all(bytes),
            Self::Stderr => io::stderr().write_all(bytes).or(Ok(())),
        })
    }
}

/// Escapes characters that control the terminal, because names of files and text from boards may
/// contain them.
///
/// Ignores a closed pipe, because a command continues without a reader of its messages: a picture
/// still has to be written. Also ignores all errors of stderr, since there is no place to report
/// them.
impl Write for Console {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let text = escaped_lines(&String::from_utf8_lossy(bytes));
        self.write_control(text.as_bytes()).map(|()| bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        match self {
            Self::Stdout => named(io::stdout().flush()),
            Self::Stderr => Ok(()),
        }
    }
}

/// Adds the name of the stream to the message of an error, and drops the error of a closed pipe.
fn named(written: io::Result<()>) -> io::Result<()> {
    written.or_else(|error| match error.kind() {
        ErrorKind::BrokenPipe => Ok(()),
        kind => {
            let message = format!("stdout: cannot be written: {error}");
            Err(io::Error::new(kind, message))
        }
    })
}
