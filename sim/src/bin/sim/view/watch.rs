use std::ffi::OsString;
use std::path::Path;
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

use notify::{Event, RecommendedWatcher, RecursiveMode, Watcher};

use crate::outcome::Outcome;

/// Time without further changes after which a change is reported. Editors save a file in several
/// steps, and the waiting time combines these steps into one change.
const DEBOUNCE: Duration = Duration::from_millis(50);

/// Watches scene files for changes.
///
/// Many editors save a file by replacing it with a new file. A watch on the old file would miss
/// this, so the directories of the files are watched.
pub(super) struct Watch {
    events: Receiver<notify::Result<Event>>,
    names: Vec<OsString>,
    /// Time of the last change, if it is not reported yet.
    last: Option<Instant>,
    _watcher: RecommendedWatcher,
}

impl Watch {
    /// Starts to watch the files.
    pub(super) fn new<'p>(files: impl Iterator<Item = &'p Path>) -> Outcome<Self> {
        let (sender, events) = channel();
        let mut watcher = notify::recommended_watcher(sender)?;
        let (mut names, mut directories) = (Vec::new(), Vec::new());
        for file in files {
            let file = std::path::absolute(file)?;
            names.extend(file.file_name().map(OsString::from));
            directories.extend(file.parent().map(Path::to_owned));
        }
        directories.sort();
        directories.dedup();
        for directory in directories {
            watcher
                .watch(&directory, RecursiveMode::NonRecursive)
                .map_err(|error| format!("{}: cannot be watched: {error}", directory.display()))?;
        }
        Ok(Self {
            events,
            names,
            last: None,
            _watcher: watcher,
        })
    }

    /// Returns true once after a file has changed.
    pub(super) fn has_changed(&mut self) -> bool {
        while let Ok(event) = self.events.try_recv() {
            if event.is_ok_and(|event| self.is_relevant(&event)) {
                self.last = Some(Instant::now());
            }
        }
        self.last
            .take_if(|last| last.elapsed() >= DEBOUNCE)
            .is_some()
    }

    /// Returns true if an event reports that a watched file was written, moved or removed. Returns
    /// false if a file was only read.
    fn is_relevant(&self, event: &Event) -> bool {
        let mut names = event.paths.iter().filter_map(|path| path.file_name());
        !event.kind.is_access() && names.any(|name| self.names.iter().any(|known| known == name))
    }
}
