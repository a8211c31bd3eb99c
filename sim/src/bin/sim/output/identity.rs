//! Identity of files. All names, links and spellings of one file have the same identity.

#[cfg(not(unix))]
use std::fs;
#[cfg(unix)]
use std::fs::{self, File, Metadata};
#[cfg(unix)]
use std::io;
#[cfg(unix)]
use std::os::{fd::AsFd, unix::fs::MetadataExt};
use std::path::Path;

/// Identity of a file: its device and inode number, or its canonical path on systems without inode
/// numbers.
#[derive(PartialEq, Eq)]
pub(super) struct FileId(#[cfg(unix)] [u64; 2], #[cfg(not(unix))] std::path::PathBuf);

#[cfg(unix)]
impl FileId {
    /// Returns the identity of an input or output of a command. Returns `None` for pipes and
    /// devices, which can be read and written at the same time.
    pub(super) fn of(path: &Path) -> Option<Self> {
        let metadata = match path.to_str() {
            Some("-") => metadata(io::stdin()),
            _ => fs::metadata(path).ok(),
        };
        metadata.filter(Metadata::is_file).map(|it| Self::new(&it))
    }

    /// Returns the identity of the file that stdout writes to.
    pub(super) fn of_stdout() -> Option<Self> {
        let metadata = metadata(io::stdout()).filter(Metadata::is_file)?;
        Some(Self::new(&metadata))
    }

    fn new(metadata: &Metadata) -> Self {
        Self([metadata.dev(), metadata.ino()])
    }
}

/// Returns true if a path names the file, pipe or device that stdout writes to.
#[cfg(unix)]
pub(super) fn names_stdout(path: &Path) -> bool {
    let (Ok(named), Some(stdout)) = (fs::metadata(path), metadata(io::stdout())) else {
        return false;
    };
    FileId::new(&named) == FileId::new(&stdout)
}

#[cfg(unix)]
fn metadata(stream: impl AsFd) -> Option<Metadata> {
    let descriptor = stream.as_fd().try_clone_to_owned().ok()?;
    File::from(descriptor).metadata().ok()
}

#[cfg(not(unix))]
impl FileId {
    pub(super) fn of(path: &Path) -> Option<Self> {
        fs::canonicalize(path).ok().map(Self)
    }

    pub(super) fn of_stdout() -> Option<Self> {
        None
    }
}

#[cfg(not(unix))]
pub(super) fn names_stdout(_path: &Path) -> bool {
    false
}
