//! List of the temporary files, which are removed when a signal ends the program.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::{fs, io, mem};

use super::signals;

/// The temporary files of this program.
static REGISTRY: Mutex<Registry> = Mutex::new(Registry {
    handles_signals: false,
    directories: BTreeSet::new(),
    files: BTreeSet::new(),
});

/// Temporary files and their directories. While the registry is locked, no signal ends the program.
/// A file is therefore created or renamed while the registry is locked.
pub(super) struct Registry {
    handles_signals: bool,
    directories: BTreeSet<PathBuf>,
    files: BTreeSet<PathBuf>,
}

/// Locks the registry. The first call installs the signal handler.
pub(super) fn registry() -> io::Result<MutexGuard<'static, Registry>> {
    let mut registry = lock();
    if !registry.handles_signals {
        signals::handle(remove_all)?;
        registry.handles_signals = true;
    }
    Ok(registry)
}

fn lock() -> MutexGuard<'static, Registry> {
    REGISTRY.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Removes all temporary files. The registry stays locked, so that the program creates no more.
fn remove_all() {
    let registry = lock();
    for file in &registry.files {
        _ = fs::remove_file(file);
    }
    mem::forget(registry);
}

impl Registry {
    /// Adds the directory of an output. Returns true if the directory is new.
    pub(super) fn enter(&mut self, directory: &Path) -> bool {
        self.directories.insert(directory.to_owned())
    }

    pub(super) fn add(&mut self, file: &Path) {
        self.files.insert(file.to_owned());
    }

    pub(super) fn remove(&mut self, file: &Path) {
        self.files.remove(file);
    }
}
