use core::ffi::CStr;
use core::fmt;

use embedded_graphics_core::prelude::Size;

use crate::host;

/// What the host asks for: a file's scene, drawn at a size.
pub struct Job<'b> {
    /// The size to draw at.
    pub size: Size,
    /// What the file holds.
    pub file: &'b [u8],
}

impl<'b> Job<'b> {
    /// The one on the command line, read into the buffer. Not inlined, as the line takes
    /// 512 bytes of stack.
    #[inline(never)]
    pub fn read(buffer: &'b mut [u8]) -> Result<Self, Failure> {
        let mut command_line = [0; 512];
        let (size, path) = host::command_line(&mut command_line)
            .and_then(parse)
            .ok_or(Failure::CommandLine)?;
        let room = buffer.len();
        let file = host::read_file(path, buffer).ok_or(Failure::File { room })?;
        Ok(Self { size, file })
    }
}

/// Takes "WIDTHxHEIGHT PATH" apart.
fn parse(command_line: &CStr) -> Option<(Size, &CStr)> {
    let (first, _) = command_line.to_str().ok()?.split_once(' ')?;
    let (width, height) = first.split_once('x')?;
    let size = Size::new(width.parse().ok()?, height.parse().ok()?);
    let rest = command_line.to_bytes_with_nul().get(first.len() + 1..)?;
    Some((size, CStr::from_bytes_until_nul(rest).ok()?))
}

/// Why there is no job.
pub enum Failure {
    /// It does not name one.
    CommandLine,
    /// The file cannot be read into so many bytes.
    File {
        /// The bytes.
        room: usize,
    },
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::CommandLine => f.write_str("the command line is not WIDTHxHEIGHT FILE"),
            Self::File { room } => {
                write!(f, "the file cannot be read, or is over {room} bytes")
            }
        }
    }
}
