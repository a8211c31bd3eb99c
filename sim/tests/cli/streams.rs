//! Stdin, stdout, pipes and full disks.

use std::error::Error;
use std::fs;
use std::os::unix::fs::symlink;
use std::process::{Command, Output};

use crate::directory::{Directory, Outcome};

const SIZE: [&str; 2] = ["--size", "32x24"];

/// Runs a command of the shell, with the program as the function `sim`.
fn shell(here: &Directory, command: &str) -> Result<Output, Box<dyn Error>> {
    let script = format!("sim() {{ \"$SIM\" \"$@\"; }}\n{command}");
    let mut shell = Command::new("sh");
    shell.current_dir(&here.0).args(["-c", &script]);
    Ok(shell.env("SIM", env!("CARGO_BIN_EXE_sim")).output()?)
}

#[test]
fn dash_is_stdin_and_stdout() -> Outcome {
    let here = Directory::empty("dash")?;
    let files = [
        ("render", "x.png", &["--stats"][..]),
        ("render", "x16.png", &["--linear16"]),
        ("animate", "x.gif", &["--frames", "2"]),
        (
            "animate",
            "x.apng",
            &["--frames", "2", "--container", "apng"],
        ),
    ];
    for (command, file, options) in files {
        let write = |output| [&[command, "whitted", "-o", output], options, &SIZE].concat();
        let named = match file.ends_with(".apng") {
            true => [&[command, "whitted", "-o", file], &options[..2], &SIZE].concat(),
            false => write(file),
        };
        let messages = here.ok(&named)?;
        let output = here.command(&write("-")).output()?;
        assert_eq!(output.status.code(), Some(0));
        assert!(output.stdout == fs::read(here.0.join(file))?, "{file}");
        // All messages except the name of the written file go to stderr.
        let without_name = |text: String| {
            let lines = text.lines().filter(|line| !line.starts_with("wrote "));
            lines
                .filter(|line| !line.starts_with("time"))
                .map(str::to_owned)
                .collect::<Vec<_>>()
        };
        assert_eq!(
            without_name(String::from_utf8(output.stderr)?),
            without_name(messages)
        );
    }
    here.ok(&["compile", "whitted", "-o", "x.scene"])?;
    let piped = shell(
        &here,
        "sim compile whitted -o - | sim compile - -o - | sim render - --size 32x24",
    )?;
    assert_eq!(piped.status.code(), Some(0));
    let wrote = format!("wrote {}\n", here.0.join("stdin.png").display());
    assert_eq!(String::from_utf8(piped.stdout)?, wrote);
    assert!(fs::read(here.0.join("stdin.png"))? == fs::read(here.0.join("x.png"))?);
    assert!(!here.0.join("-").exists());
    Ok(())
}

/// A pipe or a device needs no extension, and is not replaced by a file.
#[test]
fn writes_pipes_and_devices_in_place() -> Outcome {
    let here = Directory::empty("fifo")?;
    here.ok(&[&["render", "whitted", "-o", "x.png"], &SIZE[..]].concat())?;
    let output = shell(
        &here,
        "mkfifo pipe; cat pipe > copy.png & sim render whitted --size 32x24 -o pipe; wait
        sim render whitted --size 32x24 -o /dev/null
        sim render whitted --size 32x24 -o /dev/stdout > stdout.png",
    )?;
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let picture = fs::read(here.0.join("x.png"))?;
    assert!(fs::read(here.0.join("copy.png"))? == picture);
    assert!(fs::read(here.0.join("stdout.png"))? == picture);
    assert_eq!(here.files()?, ["copy.png", "pipe", "stdout.png", "x.png"]);
    Ok(())
}

#[test]
fn closed_pipe_is_no_error() -> Outcome {
    let here = Directory::empty("closed")?;
    for command in [
        "displays",
        "explain whitted 160 120",
        "check whitted",
        "render whitted --size 32x24 --stats",
        "render whitted --size 32x24 -o -",
        "animate whitted --size 32x24 --frames 9 -o -",
        "--help",
    ] {
        // The reader has gone before the program starts.
        let script =
            format!("{{ sleep 0.2; sim {command}; echo $? > status; }} | true; cat status");
        let output = shell(&here, &script)?;
        let [stdout, stderr] = [output.stdout, output.stderr].map(String::from_utf8);
        assert_eq!(
            (stdout?, stderr?),
            ("0\n".to_owned(), String::new()),
            "{command}"
        );
    }
    assert!(here.0.join("whitted.png").exists());
    // An error without a reader keeps its exit code.
    let script = "{ sleep 0.2; sim check nothing 2>&1; echo $? > status; } | true; cat status";
    assert_eq!(String::from_utf8(shell(&here, script)?.stdout)?, "2\n");
    Ok(())
}

/// `/dev/full` behaves as a full disk.
#[cfg(target_os = "linux")]
#[test]
fn full_disk_is_an_error() -> Outcome {
    let here = Directory::empty("full")?;
    fs::create_dir(here.0.join("out"))?;
    let cases = [
        ("render", "x.png", &[][..]),
        ("render", "x.png", &["--linear16"]),
        ("animate", "x.gif", &["--frames", "2"]),
        ("animate", "x.apng", &["--frames", "2"]),
        ("animate", "out/frame-0000.png", &["--frames", "1"]),
        ("compile", "x.scene", &[]),
        ("gallery", "out/whitted.png", &[]),
        ("gallery", "out/contact-sheet.png", &[]),
        ("gallery", "out/index.html", &[]),
    ];
    for (command, file, options) in cases {
        let link = here.0.join(file);
        symlink("/dev/full", &link)?;
        let output = match file.starts_with("out/") {
            true => "out/",
            false => file,
        };
        let size = if command == "compile" { &[][..] } else { &SIZE };
        let args = [&[command, "whitted", "-o", output], options, size].concat();
        let output = here.command(&args).output()?;
        let message = String::from_utf8(output.stderr)?;
        let expected = format!("error: {file}: cannot be written: No space left on device");
        assert!(message.starts_with(&expected), "{message}");
        assert_eq!(output.status.code(), Some(2));
        assert!(link.is_symlink());
        fs::remove_file(link)?;
    }
    let output = shell(&here, "sim displays > /dev/full")?;
    assert_eq!(output.status.code(), Some(2));
    Ok(())
}
