//! Reads scenes from files and pipes of any size.

use std::fs::File;
use std::io::{Error, ErrorKind, Read, Result};
use std::path::Path;

/// Largest scene file or compiled scene, in bytes.
pub const MAX_LEN: usize = 1 << 20;

/// Reads the whole file at a path.
///
/// # Errors
/// Returns an error if the file cannot be read or is larger than [`MAX_LEN`]. At most one byte more
/// than [`MAX_LEN`] is read, so that an endless pipe or device also ends with an error.
pub fn read(path: &Path) -> Result<Vec<u8>> {
    read_from(File::open(path)?)
}

/// Reads the rest of an open file or pipe.
///
/// # Errors
/// Returns the same errors as [`read`].
pub fn read_from(input: impl Read) -> Result<Vec<u8>> {
    let mut bytes = Vec::new();
    input.take(MAX_LEN as u64 + 1).read_to_end(&mut bytes)?;
    if bytes.len() > MAX_LEN {
        let reason = "larger than 1 MiB, the limit for scenes";
        return Err(Error::new(ErrorKind::FileTooLarge, reason));
    }
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use std::io::repeat;

    use super::*;

    #[test]
    fn ends_at_the_limit() -> Result<()> {
        let length = MAX_LEN as u64;
        assert_eq!(read_from(repeat(0).take(length))?.len(), MAX_LEN);
        for endless in [repeat(0).take(length + 1), repeat(0).take(u64::MAX)] {
            let error = read_from(endless).map_or_else(|error| error.kind(), |_| ErrorKind::Other);
            assert_eq!(error, ErrorKind::FileTooLarge);
        }
        Ok(())
    }
}
