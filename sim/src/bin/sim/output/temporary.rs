//! New files under temporary names.

use std::fs::{self, File, Metadata, OpenOptions};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

use tempfile::{Builder, NamedTempFile};

use super::registry::registry;

/// Temporary files have this prefix and suffix, with random characters between.
const PREFIX: &str = ".whitted-sim-";
const SUFFIX: &str = ".tmp";

/// A file under a temporary name, in the directory of the file that it replaces. Errors and signals
/// remove the file. Only a killed program leaves it behind, and the next run removes it.
///
/// The program locks the file while it writes, so that other runs do not remove it.
pub(super) struct Temporary {
    file: NamedTempFile,
    target: PathBuf,
}

impl Temporary {
    /// Creates a file that will replace the file `target`. Its permissions are those of the old
    /// file.
    pub(super) fn create(target: PathBuf) -> io::Result<Self> {
        // A read-only file must not be replaced, although a rename would succeed.
        let old = match OpenOptions::new().append(true).open(&target) {
            Ok(file) => Some(file.metadata()?),
            Err(error) if error.kind() == ErrorKind::NotFound => None,
            Err(error) => return Err(error),
        };
        let directory = target.parent().unwrap_or(Path::new("."));
        if registry()?.enter(directory) {
            remove_abandoned(directory)?;
        }
        let file = new_file(directory)?;
        if let Some(old) = old {
            keep_owner(file.as_file(), &old);
            file.as_file().set_permissions(old.permissions())?;
        }
        Ok(Self { file, target })
    }

    pub(super) fn file(&self) -> &File {
        self.file.as_file()
    }

    /// Gives the complete file its name. Some file systems report a full disk only when the content
    /// is stored on the disk, so this happens before.
    pub(super) fn rename(self) -> io::Result<()> {
        let Self { file, target } = self;
        file.as_file().sync_all()?;
        let mut registry = registry()?;
        registry.remove(file.path());
        file.persist(target).map_err(|error| error.error)?;
        Ok(())
    }
}

fn new_file(directory: &Path) -> io::Result<NamedTempFile> {
    let mut builder = Builder::new();
    builder.prefix(PREFIX).suffix(SUFFIX);
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    loop {
        let mut registry = registry()?;
        let file = builder.tempfile_in(directory)?;
        registry.add(file.path());
        drop(registry);
        // Another run may have found the file before it was locked. That run then removes the file
        // while it holds the lock. File systems without locks are rare, and the file is used there
        // without a lock.
        _ = file.as_file().lock();
        if file.path().exists() {
            return Ok(file);
        }
    }
}

/// Removes the temporary files that killed programs left in a directory.
fn remove_abandoned(directory: &Path) -> io::Result<()> {
    for entry in fs::read_dir(directory)? {
        let entry = entry?;
        let name = entry.file_name();
        let name = name.to_string_lossy();
        if !name.starts_with(PREFIX) || !name.ends_with(SUFFIX) {
            continue;
        }
        // The lock shows that no program writes the file.
        if let Ok(file) = File::open(entry.path())
            && file.try_lock().is_ok()
        {
            _ = fs::remove_file(entry.path());
        }
    }
    Ok(())
}

/// Gives a new file the owner of the old file, if the user is allowed to.
#[cfg(unix)]
fn keep_owner(file: &File, old: &Metadata) {
    use std::os::unix::fs::{MetadataExt, fchown};
    _ = fchown(file, Some(old.uid()), Some(old.gid()));
}

#[cfg(not(unix))]
fn keep_owner(_file: &File, _old: &Metadata) {}
