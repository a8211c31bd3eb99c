use std::sync::Mutex;
use std::thread;

use anyhow::{Context, Result};

/// Number of emulators that run at the same time.
const THREADS: usize = 2;

/// Calls a function for each item on two threads. Returns the results in the order of the items. If
/// calls fail, still handles all other items, and then returns the error of the first failed item.
pub(crate) fn map<T: Sync, R: Send>(
    items: &[T],
    work: impl Fn(&T) -> Result<R> + Sync,
) -> Result<Vec<R>> {
    let queue = Mutex::new(items.iter().enumerate());
    let next = || queue.lock().ok()?.next();
    let worker = || {
        let mut done = Vec::new();
        while let Some((index, item)) = next() {
            done.push((index, work(item)));
        }
        done
    };
    let mut results = Vec::new();
    thread::scope(|scope| {
        let threads: Vec<_> = (0..THREADS).map(|_| scope.spawn(worker)).collect();
        for thread in threads {
            results.extend(thread.join().ok().context("a worker thread panicked")?);
        }
        anyhow::Ok(())
    })?;
    results.sort_by_key(|(index, _)| *index);
    results.into_iter().map(|(_, result)| result).collect()
}
