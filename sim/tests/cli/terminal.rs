//! `sim` without a command, in a terminal.

use std::fs::File;
use std::io::{ErrorKind, Read};
use std::process::Stdio;
use std::time::{Duration, Instant};

use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};

use crate::directory::{Directory, Outcome};

/// A terminal that claims to be kitty but does not answer. The program must not wait for answers.
#[test]
fn does_not_wait_for_a_silent_terminal() -> Outcome {
    for name in ["xterm-kitty", "xterm-256color"] {
        let here = Directory::empty("silent")?;
        let terminal = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY)?;
        grantpt(&terminal)?;
        unlockpt(&terminal)?;
        let path = ptsname(&terminal, Vec::new())?;
        let open = || {
            File::options()
                .read(true)
                .write(true)
                .open(path.to_str().unwrap_or(""))
        };
        let mut command = here.command(&[]);
        command.stdin(open()?).stdout(open()?).stderr(Stdio::null());
        let mut program = command.env("TERM", name).spawn()?;
        drop(command);
        let reader = std::thread::spawn(move || read_all(File::from(terminal)));
        let start = Instant::now();
        while program.try_wait()?.is_none() {
            if start.elapsed() > Duration::from_secs(60) {
                program.kill()?;
            }
            std::thread::sleep(Duration::from_millis(10));
        }
        assert_eq!(program.wait()?.code(), Some(0), "{name}");
        assert!(here.0.join("whitted.png").exists());
        let shown = reader.join().map_err(|_| "the thread fails")??;
        let text = String::from_utf8_lossy(&shown);
        assert_eq!(
            text.contains("\x1b_Ga=T,"),
            name.contains("kitty"),
            "{text}"
        );
        assert!(text.trim_end().ends_with("whitted.png"), "{text}");
    }
    Ok(())
}

/// Reads until the last program closes the terminal.
fn read_all(mut terminal: File) -> Result<Vec<u8>, std::io::Error> {
    let (mut bytes, mut chunk) = (Vec::new(), [0; 4096]);
    loop {
        match terminal.read(&mut chunk) {
            Ok(0) => return Ok(bytes),
            Ok(length) => bytes.extend(&chunk[..length]),
            // Linux reports the end in this way.
            Err(error) if error.raw_os_error() == Some(5) => return Ok(bytes),
            Err(error) if error.kind() == ErrorKind::Interrupted => {}
            Err(error) => return Err(error),
        }
    }
}
