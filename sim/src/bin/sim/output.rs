//! Writes the output of a command to a file, a pipe, a device or stdout.
//!
//! ```text
//! path ── target (what it names) ── identity (no input) ── temporary (new file) ──> rename
//!                   └──> pipe, device, stdout: written in place
//! ```

mod file_type;
mod identity;
mod picture;
mod registry;
mod signals;
mod target;
mod temporary;

use std::error::Error;
use std::fmt;
use std::fs::{File, OpenOptions};
use std::io::{self, BufWriter, ErrorKind, Write};
use std::path::{Path, PathBuf};

use crate::outcome::Outcome;
pub(crate) use file_type::{FileType, extension};
use identity::FileId;
pub(crate) use picture::{io_error, write_png};
use target::Target;
pub(crate) use target::{is_stdout, is_stream};
use temporary::Temporary;

/// An output that was checked and opened, but that has no content yet.
///
/// A file gets its content under a temporary name in the same directory, and its own name when it
/// is complete. At any time, the path names the complete old file or the complete new file.
pub(crate) struct Output {
    name: String,
    sink: Sink,
}

enum Sink {
    Stdout,
    /// A pipe or a device.
    Stream(File),
    File(Temporary),
}

impl Output {
    /// Opens an output before the work for its content begins.
    ///
    /// Returns an error if the path cannot be written, if its name does not belong to the type of
    /// file, or if it names one of the `inputs` of the command.
    pub(crate) fn create(path: &Path, file_type: &FileType, inputs: &[PathBuf]) -> Outcome<Self> {
        let target = Self::check(path, file_type, inputs)?;
        let name = path.display().to_string();
        let sink = match target {
            Target::Stdout => Ok(Sink::Stdout),
            Target::Stream(path) => OpenOptions::new().write(true).open(path).map(Sink::Stream),
            Target::File(path) => Temporary::create(path).map(Sink::File),
        };
        let sink = sink.map_err(|error| unwritable(&name, &error))?;
        Ok(Self { name, sink })
    }

    /// Checks an output without opening it. Returns the same errors as [`Output::create`], except
    /// that the directory may be read-only.
    pub(crate) fn check(path: &Path, file_type: &FileType, inputs: &[PathBuf]) -> Outcome<Target> {
        let target = Target::of(path).map_err(|error| unwritable(&path.display(), &error))?;
        let id = match &target {
            Target::Stdout => FileId::of_stdout(),
            Target::Stream(_) => None,
            Target::File(path) => FileId::of(path),
        };
        let mut inputs = inputs.iter();
        if let Some(input) = inputs.find(|input| id.is_some() && FileId::of(input) == id) {
            let (path, input) = (path.display(), input.display());
            let help = "choose another file for the output";
            return Err(format!("{path}: is the scene `{input}` itself\n  help: {help}").into());
        }
        match target {
            Target::File(_) => file_type.check(path)?,
            Target::Stdout => target::refuse_terminal()?,
            Target::Stream(_) => {}
        }
        Ok(target)
    }

    /// Writes the content of the output. If `encode` fails, a file keeps its old content.
    pub(crate) fn write(self, encode: impl FnOnce(&mut dyn Write) -> Outcome) -> Outcome {
        let Self { name, sink } = self;
        let written = match sink {
            Sink::Stdout => buffered(io::stdout().lock(), encode),
            Sink::Stream(file) => buffered(file, encode),
            Sink::File(temporary) => buffered(temporary.file(), encode)
                .and_then(|()| temporary.rename().map_err(Into::into)),
        };
        written.map_err(|error| match error.downcast::<io::Error>() {
            Ok(error) => unwritable(&name, &error),
            Err(other) => other,
        })
    }
}

fn buffered(sink: impl Write, encode: impl FnOnce(&mut dyn Write) -> Outcome) -> Outcome {
    let mut writer = BufWriter::new(sink);
    encode(&mut writer)?;
    // The destructor of the writer would ignore the error of the last bytes.
    Ok(writer.flush()?)
}

/// Returns the error for an output that cannot be written.
pub(crate) fn unwritable(name: &dyn fmt::Display, error: &io::Error) -> Box<dyn Error> {
    match error.kind() {
        ErrorKind::BrokenPipe => Box::new(ClosedPipe),
        ErrorKind::NotFound => {
            let help = "create the directory of the file";
            format!("{name}: cannot be written: {error}\n  help: {help}").into()
        }
        _ => format!("{name}: cannot be written: {error}").into(),
    }
}

/// The reader of the output has gone. The program then ends without a message.
#[derive(Debug)]
pub(crate) struct ClosedPipe;

impl fmt::Display for ClosedPipe {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the reader of the output has gone")
    }
}

impl Error for ClosedPipe {}
