#[cfg(unix)]
use std::{io, process, sync::Arc, thread};

#[cfg(unix)]
use signal_hook::{
    consts::{SIGINT, SIGTERM, SIGXFSZ},
    flag,
    iterator::Signals,
    low_level::emulate_default_handler,
};

/// Calls a function when the signal SIGINT or SIGTERM arrives, and then ends the program as the
/// signal does by default.
#[cfg(unix)]
pub(super) fn handle(before_end: fn()) -> io::Result<()> {
    // Without a handler, this signal would kill the program when a file exceeds the size limit of
    // the shell. With a handler, the write fails.
    flag::register(SIGXFSZ, Arc::default())?;
    let mut signals = Signals::new([SIGINT, SIGTERM])?;
    let wait = move || {
        if let Some(signal) = signals.forever().next() {
            before_end();
            _ = emulate_default_handler(signal);
            process::exit(128 + signal);
        }
    };
    thread::Builder::new().spawn(wait).map(drop)
}

/// Other systems end the program without a signal. The next run removes its temporary file.
#[cfg(not(unix))]
pub(super) fn handle(_before_end: fn()) -> std::io::Result<()> {
    Ok(())
}
