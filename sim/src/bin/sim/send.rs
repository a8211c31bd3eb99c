//! Sends a scene to a board, by a serial port, and tells what it says.

use std::io::ErrorKind;
use std::path::Path;
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

use scene_serial::{Answer, frame, frame_len};
use serial2::SerialPort;

use crate::args::Send;
use crate::open::Scene;
use crate::outcome::Outcome;

/// A board looks at what came after each line, which takes two seconds at most.
const PATIENCE: Duration = Duration::from_secs(5);

/// USB has no such thing, but ports want one.
const BAUD: u32 = 115_200;

const NOBODY: &str = "nothing answers
  help: is it the board's port, and its firmware that of boards/pico? (`cargo run --release` there)";
const REFUSED: &str = "
  help: flash firmware of the same version as this program, or leave something out of the scene";
const BROKEN: &str = "\n  help: send it again; if that does not help, try another cable";

pub(crate) fn send(options: &Send) -> Outcome {
    let compiled = Scene::open(&options.scene)?.compile()?;
    let Some(path) = &options.port else {
        return Err(format!("no port: name it by `--port`{}", ports()).into());
    };
    let port = open(path)?;
    let said = exchange(&port, &compiled).map_err(|why| format!("{}: {why}", path.display()))?;
    println!("{}: {said}", path.display());
    Ok(())
}

fn open(path: &Path) -> Result<SerialPort, String> {
    SerialPort::open(path, BAUD).map_err(|error| {
        let help = match error.kind() {
            ErrorKind::NotFound => ports(),
            ErrorKind::PermissionDenied => {
                "\n  help: on Linux, ports are for members of the group dialout or uucp".to_owned()
            }
            _ => String::new(),
        };
        format!("{}: cannot be opened: {error}{help}", path.display())
    })
}

/// Advice that names the ports that there are.
fn ports() -> String {
    let ports = SerialPort::available_ports().unwrap_or_default();
    let names: Vec<_> = ports
        .iter()
        .map(|port| port.display().to_string())
        .collect();
    match names.is_empty() {
        true => "\n  help: there is no serial port; is the board plugged in?".to_owned(),
        false => format!("\n  help: there are {}", names.join(", ")),
    }
}

/// Sends, and waits for the answer.
fn exchange(port: &SerialPort, compiled: &[u8]) -> Result<&'static str, String> {
    let ticket = ticket();
    let mut bytes = vec![0; frame_len(compiled.len())];
    let frame = frame(ticket, compiled, &mut bytes).ok_or("the scene is too long")?;
    match port.write_all(frame) {
        Err(error) if error.kind() == ErrorKind::TimedOut => return Err(NOBODY.to_owned()),
        written => written.map_err(|error| error.to_string())?,
    }

    let deadline = Instant::now() + PATIENCE;
    let mut lines = Lines {
        port,
        bytes: Vec::new(),
    };
    let mut broken = None;
    while let Some(line) = lines.before(deadline)? {
        match Answer::parse(&line) {
            Some(Answer::Shown { ticket: its }) if its == ticket => return Ok("shown"),
            Some(Answer::Refused { ticket: its, why }) if its == ticket => {
                return Err(format!("the board refuses the scene: {why}{REFUSED}"));
            }
            // Perhaps what somebody else began to send, before.
            Some(Answer::Broken { why }) => {
                broken = Some(format!("the scene did not arrive: {why}{BROKEN}"));
            }
            _ => {}
        }
    }
    Err(broken.unwrap_or_else(|| NOBODY.to_owned()))
}

/// A number that the last transfer most likely did not have.
fn ticket() -> u16 {
    let since = SystemTime::now().duration_since(UNIX_EPOCH);
    since.unwrap_or_default().as_millis() as u16
}

/// What a port says.
struct Lines<'p> {
    port: &'p SerialPort,
    /// What came after the last line.
    bytes: Vec<u8>,
}

impl Lines<'_> {
    /// The next line, if it comes in time.
    fn before(&mut self, deadline: Instant) -> Result<Option<String>, String> {
        loop {
            if let Some(end) = self.bytes.iter().position(|byte| *byte == b'\n') {
                let line: Vec<u8> = self.bytes.drain(..=end).collect();
                return Ok(Some(
                    String::from_utf8_lossy(line.trim_ascii_end()).into_owned(),
                ));
            }
            if Instant::now() > deadline {
                return Ok(None);
            }
            let mut some = [0; 256];
            match self.port.read(&mut some) {
                Ok(0) => return Err("the port was closed".to_owned()),
                Ok(length) => self.bytes.extend(some.iter().take(length)),
                Err(error) if error.kind() == ErrorKind::TimedOut => {}
                Err(error) => return Err(error.to_string()),
            }
        }
    }
}
