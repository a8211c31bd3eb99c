use std::ffi::OsString;
use std::path::Path;
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

use notify::{Event, RecommendedWatcher, RecursiveMode, Watcher};

use crate::outcome::Outcome;

/// How long files must rest: an editor may take several steps to save one.
const REST: Duration = Duration::from_millis(50);

/// Watches files; their directories in truth, as editors put a new file in the
/// place of the old one.
pub(super) struct Watch {
    events: Receiver<notify::Result<Event>>,
    names: Vec<OsString>,
    /// When a file changed last that was not told of yet.
    last: Option<Instant>,
    _watcher: RecommendedWatcher,
}

impl Watch {
    /// Begins to watch.
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

    /// Whether a file has changed, and rests now. Told once.
    pub(super) fn has_changed(&mut self) -> bool {
        while let Ok(event) = self.events.try_recv() {
            if event.is_ok_and(|event| self.concerns(&event)) {
                self.last = Some(Instant::now());
            }
        }
        self.last.take_if(|last| last.elapsed() >= REST).is_some()
    }

    /// Whether a file was written, moved or removed. To be read changes nothing.
    fn concerns(&self, event: &Event) -> bool {
        let mut names = event.paths.iter().filter_map(|path| path.file_name());
        !event.kind.is_access() && names.any(|name| self.names.iter().any(|known| known == name))
    }
}
