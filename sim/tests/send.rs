//! Tests `sim send`. The test itself plays the board, at the other end of a pseudo-terminal.
#![cfg(unix)]

use std::error::Error;
use std::process::{Command, Output};
use std::thread;

use scene_serial::{Answer, Receiver};
use serial2::SerialPort;
use whitted_sim::scene_file;

type Outcome<T = ()> = Result<T, Box<dyn Error>>;

/// Receiver that is large enough for the scene.
type Board = Receiver<2000>;

const SCENE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes/whitted.toml");

fn sim(args: &[&str]) -> Outcome<Output> {
    Ok(Command::new(env!("CARGO_BIN_EXE_sim"))
        .args(args)
        .output()?)
}

/// Runs `sim send` against a board that gives some answers to a scene with a ticket. Returns the
/// program's output, or its error.
fn send(answers: impl Fn(u16) -> Vec<String>) -> Outcome<Result<String, String>> {
    let (board, host) = SerialPort::pair()?;
    let path = rustix::pty::ptsname(&board, Vec::new())?;
    let sent = thread::scope(|scope| -> Outcome<Output> {
        let program = scope.spawn(|| {
            let path = path.to_str().unwrap_or_default();
            sim(&["send", SCENE, "--port", path]).map_err(|error| error.to_string())
        });
        let (ticket, scene) = receive(&board)?;
        assert_eq!(scene, scene_file::compile(SCENE)?);
        for line in answers(ticket) {
            board.write_all(format!("{line}\n").as_bytes())?;
        }
        Ok(program.join().map_err(|_| "the thread fails")??)
    })?;
    drop(host);
    let path = path.to_str()?;
    let output = String::from_utf8(sent.stdout)?.replace(path, "PORT");
    let error = String::from_utf8(sent.stderr)?.replace(path, "PORT");
    Ok(match sent.status.success() {
        true => Ok(output),
        false => Err(error),
    })
}

/// Receives a scene and its ticket.
fn receive(port: &SerialPort) -> Outcome<(u16, Vec<u8>)> {
    let mut board = Board::new();
    loop {
        let mut byte = [0];
        port.read_exact(&mut byte)?;
        if let Some(outcome) = board.receive(byte[0]) {
            outcome?;
            let message = board.message().ok_or("a message")?;
            return Ok((message.ticket, message.scene.to_vec()));
        }
    }
}

fn line(answer: Answer<&str>) -> String {
    answer.to_string()
}

#[test]
fn prints_that_the_scene_is_shown() -> Outcome {
    let output = send(|ticket| vec![line(Answer::Shown { ticket })])?;
    assert_eq!(output, Ok("PORT: shown\n".to_owned()));
    Ok(())
}

#[test]
fn prints_why_the_board_refuses_a_scene() -> Outcome {
    let why = "too many objects: the buffer holds 2";
    let output = send(|ticket| vec![line(Answer::Refused { ticket, why })])?;
    let expected = "error: PORT: the board refuses the scene: too many objects: the buffer holds 2
  help: flash firmware of the same version as this program, or leave something out of the scene\n";
    assert_eq!(output, Err(expected.to_owned()));
    Ok(())
}

#[test]
fn ignores_answers_to_other_transfers() -> Outcome {
    let output = send(|ticket| {
        let other = ticket.wrapping_add(1);
        vec![
            "hello".to_owned(),
            "x".repeat(100_000),
            line(Answer::Shown { ticket: other }),
            line(Answer::Refused {
                ticket: other,
                why: "no",
            }),
            line(Answer::Broken { why: "cut" }),
            line(Answer::Shown { ticket }),
        ]
    })?;
    assert_eq!(output, Ok("PORT: shown\n".to_owned()));
    Ok(())
}

#[test]
fn reports_a_damaged_transfer() -> Outcome {
    let why = "damaged on its way";
    let output = send(|_| vec![line(Answer::Broken { why })])?;
    let expected = "error: PORT: the scene did not arrive: damaged on its way
  help: send the scene again; if that fails, try another cable\n";
    assert_eq!(output, Err(expected.to_owned()));
    Ok(())
}

#[test]
fn escapes_and_shortens_the_answer() -> Outcome {
    let why = format!("\u{1b}]0;title\u{7}{}", "x".repeat(1000));
    for answer in [true, false] {
        let output = send(|ticket| {
            let why = why.as_str();
            vec![line(match answer {
                true => Answer::Refused { ticket, why },
                false => Answer::Broken { why },
            })]
        })?;
        let message = output.err().ok_or("no error")?;
        let reason = format!(r": \u{{1b}}]0;title\u{{7}}{}…", "x".repeat(50));
        assert!(message.contains(&reason), "{message}");
    }
    Ok(())
}

#[test]
fn reports_a_missing_answer() -> Outcome {
    let output = send(|_| Vec::new())?;
    let expected = "error: PORT: the board does not answer
  help: check that this is the board's port and that the board runs the firmware of boards/pico\n";
    assert_eq!(output, Err(expected.to_owned()));
    Ok(())
}

#[test]
fn errors_about_ports_list_the_available_ones() -> Outcome {
    let ports = SerialPort::available_ports()?;
    let help = match ports.first() {
        Some(first) => format!("\n  help: the available ports are {}", first.display()),
        None => "\n  help: no serial port found; check that the board is plugged in".to_owned(),
    };
    for (args, expected) in [
        (&["send", SCENE][..], "no port given: name it with `--port`"),
        (
            &["send", SCENE, "--port", "/dev/no-such-port"],
            "/dev/no-such-port: cannot be opened: ",
        ),
    ] {
        let output = sim(args)?;
        let error = String::from_utf8(output.stderr)?;
        assert_eq!(output.status.code(), Some(2));
        assert!(error.starts_with(&format!("error: {expected}")), "{error}");
        assert!(error.contains(&help), "{error}");
    }
    Ok(())
}
