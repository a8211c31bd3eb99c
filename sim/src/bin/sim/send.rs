//! `sim send`: sends a scene to a board over a serial port and prints the answer.

use std::io::{ErrorKind, Write};
use std::path::Path;
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

use scene_serial::{Answer, frame, frame_len};
use serial2::SerialPort;
use whitted_sim::text::excerpt;

use crate::args::Send;
use crate::console::Console;
use crate::open::Scene;
use crate::outcome::Outcome;

/// Longest time to wait for the answer of a board. A board reads the port after each line that it
/// renders. It renders a line in at most two seconds.
const ANSWER_TIMEOUT: Duration = Duration::from_secs(5);

/// Longest line of a board that is read, in bytes. A port may send other data without end.
const MAX_LINE: usize = 4096;

/// Baud rate of the serial port. USB ignores the rate, but opening a port requires one.
const BAUD: u32 = 115_200;

const NO_ANSWER: &str = "the board does not answer
  help: check that this is the board's port and that the board runs the firmware of boards/pico";
const REFUSED: &str = "
  help: flash firmware of the same version as this program, or leave something out of the scene";
const DAMAGED: &str = "\n  help: send the scene again; if that fails, try another cable";

/// Compiles a scene, sends it, and waits for the board's answer.
pub(crate) fn send(options: &Send) -> Outcome {
    let compiled = Scene::open(&options.scene)?.compile()?;
    let Some(path) = &options.port else {
        return Err(format!("no port given: name it with `--port`{}", ports_help()).into());
    };
    let port = open(path)?;
    let answer = exchange(&port, &compiled).map_err(|why| format!("{}: {why}", path.display()))?;
    Ok(writeln!(Console::Stdout, "{}: {answer}", path.display())?)
}

fn open(path: &Path) -> Result<SerialPort, String> {
    SerialPort::open(path, BAUD).map_err(|error| {
        let help = match error.kind() {
            ErrorKind::NotFound => ports_help(),
            ErrorKind::PermissionDenied => {
                "\n  help: on Linux, join the group that may use ports, dialout or uucp".to_owned()
            }
            _ => String::new(),
        };
        format!("{}: cannot be opened: {error}{help}", path.display())
    })
}

/// Returns the help text that lists the available ports.
fn ports_help() -> String {
    let ports = SerialPort::available_ports().unwrap_or_default();
    let names: Vec<_> = ports
        .iter()
        .map(|port| port.display().to_string())
        .collect();
    match names.is_empty() {
        true => "\n  help: no serial port found; check that the board is plugged in".to_owned(),
        false => format!("\n  help: the available ports are {}", names.join(", ")),
    }
}

/// Sends a compiled scene and waits for the board's answer.
fn exchange(port: &SerialPort, compiled: &[u8]) -> Result<&'static str, String> {
    let ticket = ticket();
    let mut bytes = vec![0; frame_len(compiled.len())];
    let frame = frame(ticket, compiled, &mut bytes).ok_or("the scene is too large to send")?;
    match port.write_all(frame) {
        Err(error) if error.kind() == ErrorKind::TimedOut => return Err(NO_ANSWER.to_owned()),
        written => written.map_err(|error| error.to_string())?,
    }

    let deadline = Instant::now() + ANSWER_TIMEOUT;
    let mut lines = Lines {
        port,
        bytes: Vec::new(),
    };
    let mut damaged = None;
    while let Some(line) = lines.next_before(deadline)? {
        match Answer::parse(&line) {
            Some(Answer::Shown { ticket: received }) if received == ticket => return Ok("shown"),
            Some(Answer::Refused {
                ticket: received,
                why,
            }) if received == ticket => {
                return Err(format!(
                    "the board refuses the scene: {}{REFUSED}",
                    excerpt(why)
                ));
            }
            // This answer may concern an earlier transfer that was interrupted, so the loop
            // continues.
            Some(Answer::Broken { why }) => {
                let why = excerpt(why);
                damaged = Some(format!("the scene did not arrive: {why}{DAMAGED}"));
            }
            _ => {}
        }
    }
    Err(damaged.unwrap_or_else(|| NO_ANSWER.to_owned()))
}

/// Returns a number that identifies a transfer: the current time in milliseconds, modulo 2^16. Two
/// successive transfers very likely have different numbers.
fn ticket() -> u16 {
    let since = SystemTime::now().duration_since(UNIX_EPOCH);
    since.unwrap_or_default().as_millis() as u16
}

/// Reads lines from a serial port.
struct Lines<'p> {
    port: &'p SerialPort,
    /// Bytes received after the last complete line.
    bytes: Vec<u8>,
}

impl Lines<'_> {
    /// Returns the next line, or `None` if no complete line arrives before the deadline.
    fn next_before(&mut self, deadline: Instant) -> Result<Option<String>, String> {
        while Instant::now() <= deadline {
            if let Some(end) = self.bytes.iter().position(|byte| *byte == b'\n') {
                let line: Vec<u8> = self.bytes.drain(..=end).collect();
                return Ok(Some(
                    String::from_utf8_lossy(line.trim_ascii_end()).into_owned(),
                ));
            }
            if self.bytes.len() > MAX_LINE {
                self.bytes.clear();
            }
            let mut chunk = [0; 256];
            match self.port.read(&mut chunk) {
                Ok(0) => return Err("the port was closed".to_owned()),
                Ok(length) => self.bytes.extend(chunk.iter().take(length)),
                Err(error) if error.kind() == ErrorKind::TimedOut => {}
                Err(error) => return Err(error.to_string()),
            }
        }
        Ok(None)
    }
}
