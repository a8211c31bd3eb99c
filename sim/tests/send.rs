//! `sim send`, with a board that is a thread at the other end of a pseudo-terminal.
#![cfg(unix)]

use std::error::Error;
use std::process::{Command, Output};
use std::thread;

use scene_serial::{Answer, Receiver};
use serial2::SerialPort;
use whitted_sim::scene_file;

type Outcome<T = ()> = Result<T, Box<dyn Error>>;

/// Room for the scene below, and more.
type Board = Receiver<2000>;

const SCENE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes/whitted.toml");

fn sim(args: &[&str]) -> Outcome<Output> {
    Ok(Command::new(env!("CARGO_BIN_EXE_sim"))
        .args(args)
        .output()?)
}

/// What the program prints, or its error, where a board gives these answers to
/// a scene with a ticket.
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
    let said = String::from_utf8(sent.stdout)?.replace(path, "PORT");
    let error = String::from_utf8(sent.stderr)?.replace(path, "PORT");
    Ok(match sent.status.success() {
        true => Ok(said),
        false => Err(error),
    })
}

/// The scene that arrives, and its ticket.
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
fn a_scene_is_shown() -> Outcome {
    let said = send(|ticket| vec![line(Answer::Shown { ticket })])?;
    assert_eq!(said, Ok("PORT: shown\n".to_owned()));
    Ok(())
}

#[test]
fn a_board_says_why_it_refuses() -> Outcome {
    let why = "too many objects: the buffer holds 2";
    let said = send(|ticket| vec![line(Answer::Refused { ticket, why })])?;
    let expected = "error: PORT: the board refuses the scene: too many objects: the buffer holds 2
  help: flash firmware of the same version as this program, or leave something out of the scene\n";
    assert_eq!(said, Err(expected.to_owned()));
    Ok(())
}

#[test]
fn answers_to_others_are_ignored() -> Outcome {
    let said = send(|ticket| {
        let other = ticket.wrapping_add(1);
        vec![
            "hello".to_owned(),
            line(Answer::Shown { ticket: other }),
            line(Answer::Refused {
                ticket: other,
                why: "no",
            }),
            line(Answer::Broken { why: "cut" }),
            line(Answer::Shown { ticket }),
        ]
    })?;
    assert_eq!(said, Ok("PORT: shown\n".to_owned()));
    Ok(())
}

#[test]
fn a_scene_may_not_arrive() -> Outcome {
    let why = "damaged on its way";
    let said = send(|_| vec![line(Answer::Broken { why })])?;
    let expected = "error: PORT: the scene did not arrive: damaged on its way
  help: send it again; if that does not help, try another cable\n";
    assert_eq!(said, Err(expected.to_owned()));
    Ok(())
}

#[test]
fn nobody_may_answer() -> Outcome {
    let said = send(|_| Vec::new())?;
    let expected = "error: PORT: nothing answers
  help: is it the board's port, and its firmware that of boards/pico? (`cargo run --release` there)\n";
    assert_eq!(said, Err(expected.to_owned()));
    Ok(())
}

#[test]
fn ports_that_are_there_are_named() -> Outcome {
    let ports = SerialPort::available_ports()?;
    let help = match ports.first() {
        Some(first) => format!("\n  help: there are {}", first.display()),
        None => "\n  help: there is no serial port; is the board plugged in?".to_owned(),
    };
    for (args, said) in [
        (&["send", SCENE][..], "no port: name it by `--port`"),
        (
            &["send", SCENE, "--port", "/dev/no-such-port"],
            "/dev/no-such-port: cannot be opened: ",
        ),
    ] {
        let output = sim(args)?;
        let error = String::from_utf8(output.stderr)?;
        assert_eq!(output.status.code(), Some(2));
        assert!(error.starts_with(&format!("error: {said}")), "{error}");
        assert!(error.contains(&help), "{error}");
    }
    Ok(())
}
