use core::ffi::CStr;
use core::fmt;

use embedded_graphics_core::prelude::Size;

use crate::host;

/// Rendering job from the command line: the content of a scene file and the image size.
pub struct Job<'b> {
    /// Image size in pixels.
    pub size: Size,
    /// Content of the scene file.
    pub file: &'b [u8],
}

impl<'b> Job<'b> {
    /// Reads the job from the command line and loads the scene file into `buffer`.
    ///
    /// The function is kept out of line, so that the caller's stack frame does not include
    /// the 512 bytes of the command line.
    ///
    /// # Errors
    /// Returns an error if the command line is malformed or the file cannot be read.
    #[inline(never)]
    pub fn read(buffer: &'b mut [u8]) -> Result<Self, JobError> {
        let mut command_line = [0; 512];
        let (size, path) = host::command_line(&mut command_line)
            .and_then(parse)
            .ok_or(JobError::CommandLine)?;
        let capacity = buffer.len();
        let file = host::read_file(path, buffer).ok_or(JobError::File { capacity })?;
        Ok(Self { size, file })
    }
}

/// Parses a command line of the form "WIDTHxHEIGHT PATH".
fn parse(command_line: &CStr) -> Option<(Size, &CStr)> {
    let (first, _) = command_line.to_str().ok()?.split_once(' ')?;
    let (width, height) = first.split_once('x')?;
    let size = Size::new(width.parse().ok()?, height.parse().ok()?);
    let rest = command_line.to_bytes_with_nul().get(first.len() + 1..)?;
    Some((size, CStr::from_bytes_until_nul(rest).ok()?))
}

/// The reason why no job could be read.
pub enum JobError {
    /// The command line is malformed.
    CommandLine,
    /// The file is unreadable or exceeds the buffer.
    File {
        /// Size of the buffer in bytes.
        capacity: usize,
    },
}

impl fmt::Display for JobError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::CommandLine => f.write_str("invalid command line: expected WIDTHxHEIGHT FILE"),
            Self::File { capacity } => {
                write!(
                    f,
                    "the scene file is unreadable or larger than {capacity} bytes"
                )
            }
        }
    }
}
