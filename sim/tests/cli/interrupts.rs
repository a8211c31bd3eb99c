//! Interrupts the program at many moments, and runs it twice at once. Each file must be the complete
//! old file or the complete new file, and no temporary file may remain.
//!
//! The environment variable `RUNS` sets the number of interruptions of each kind of output.

use std::collections::BTreeMap;
use std::error::Error;
use std::process::{Child, ExitStatus, Stdio};
use std::time::{Duration, Instant};
use std::{env, fs, thread};

use rustix::process::{Pid, Signal, kill_process};

use crate::directory::{Directory, Outcome};

/// Names and contents of the files in a directory.
type Files = BTreeMap<String, Vec<u8>>;

/// Outputs in the directory of a test.
const OUTPUTS: [&str; 4] = ["x.png", "x.gif", "x.apng", "frames"];

/// Prefix of the names of temporary files.
const TEMPORARY: &str = ".whitted-sim-";

/// Options of the old outputs. The old animations are longer than the new ones.
const OLD: [&[&str]; 2] = [&["--size", "40x30"], &["--size", "20x15", "--frames", "6"]];
const NEW: [&[&str]; 2] = [
    &["--size", "200x150", "--antialias", "16"],
    &["--size", "80x60", "--frames", "4"],
];

fn arguments<'a>(output: &'a str, [picture, film]: [&[&'a str]; 2]) -> Vec<&'a str> {
    match output {
        "x.png" => [&["render", "bouncing_ball", "-o", output], picture].concat(),
        _ => [&["animate", "bouncing_ball", "-o", output], film].concat(),
    }
}

fn read(here: &Directory, output: &str) -> Result<Files, Box<dyn Error>> {
    let directory = match output {
        "frames" => Directory(here.0.join(output)),
        _ => Directory(here.0.clone()),
    };
    let files = directory.files()?.into_iter();
    let read = |name: String| Ok((name.clone(), fs::read(directory.0.join(name))?));
    files.map(read).collect()
}

fn write(here: &Directory, output: &str, files: &Files) -> Outcome {
    let directory = match output {
        "frames" => here.0.join(output),
        _ => here.0.clone(),
    };
    fs::create_dir_all(&directory)?;
    for (name, bytes) in files {
        fs::write(directory.join(name), bytes)?;
    }
    Ok(())
}

/// Checks that each file is an old or a new one.
fn check(found: &Files, old: &Files, new: &Files, context: &str) {
    for (name, bytes) in found {
        let is_complete = old.get(name) == Some(bytes) || new.get(name) == Some(bytes);
        assert!(is_complete, "{context}: {name}");
    }
    // A longer old film may have lost its last frames, but only after all new frames were written.
    let is_new = new.iter().all(|file| found.get(file.0) == Some(file.1));
    let kept = old.keys().all(|name| found.contains_key(name));
    assert!(is_new || kept, "{context}: a file is missing");
}

fn spawn(here: &Directory, arguments: &[&str]) -> Result<Child, Box<dyn Error>> {
    let mut command = here.command(arguments);
    Ok(command
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()?)
}

fn kill(program: &Child, signal: Signal) -> Outcome {
    Ok(kill_process(Pid::from_child(program), signal)?)
}

/// Runs the program with a signal after `delay`, or with a size limit for files.
fn interrupt(
    here: &Directory,
    arguments: &[&str],
    run: usize,
    moment: f64,
    (time, length): (Duration, usize),
) -> Result<ExitStatus, Box<dyn Error>> {
    let signal = match run % 3 {
        0 => Signal::INT,
        1 => Signal::TERM,
        _ => {
            let blocks = (moment * length as f64 / 512.0) as usize;
            let script = format!("ulimit -f {blocks}; exec \"$SIM\" \"$@\"");
            let mut shell = std::process::Command::new("sh");
            shell
                .current_dir(&here.0)
                .args(["-c", &script, "sh"])
                .args(arguments);
            shell.env("SIM", env!("CARGO_BIN_EXE_sim"));
            return Ok(shell.output()?.status);
        }
    };
    let mut program = spawn(here, arguments)?;
    thread::sleep(time.mul_f64(moment));
    kill(&program, signal)?;
    Ok(program.wait()?)
}

#[test]
fn interrupted_outputs_are_old_or_new() -> Outcome {
    let runs = env::var("RUNS").map_or(Ok(3), |runs| runs.parse())?;
    for output in OUTPUTS {
        let here = Directory::empty(&format!("interrupt-{output}"))?;
        here.ok(&arguments(output, OLD))?;
        let old = read(&here, output)?;
        let here = Directory::empty(&format!("interrupt-{output}"))?;
        let start = Instant::now();
        here.ok(&arguments(output, NEW))?;
        let time = start.elapsed();
        let new = read(&here, output)?;
        let length = new.values().map(Vec::len).max().unwrap_or(0);
        let mut ended = [0; 2];
        for run in 0..runs {
            let here = Directory::empty(&format!("interrupt-{output}"))?;
            // In every fourth run, there is no old output.
            let old = if run % 4 == 3 {
                Files::new()
            } else {
                old.clone()
            };
            write(&here, output, &old)?;
            // Multiples of the golden ratio cover all moments evenly.
            let moment = 1.1 * (0.3 + 0.618_034 * run as f64).fract();
            let status = interrupt(&here, &arguments(output, NEW), run, moment, (time, length))?;
            let context = format!("{output}, run {run}, {status}");
            check(&read(&here, output)?, &old, &new, &context);
            ended[usize::from(status.success())] += 1;
        }
        println!("{output}: {} interrupted, {} complete", ended[0], ended[1]);
        assert!(ended[0] > 0, "{output}: no run was interrupted");
    }
    Ok(())
}

/// Starts a rendering that takes long, and waits for its temporary file.
fn start_long(here: &Directory) -> Result<Child, Box<dyn Error>> {
    let program = spawn(
        here,
        &["render", "sphereflake", "-o", "x.png", "--size", "600x450"],
    )?;
    let start = Instant::now();
    while !here.files()?.iter().any(|name| name.starts_with(TEMPORARY)) {
        assert!(
            start.elapsed() < Duration::from_secs(60),
            "no temporary file"
        );
        thread::sleep(Duration::from_millis(1));
    }
    Ok(program)
}

#[test]
fn next_run_removes_the_file_of_a_killed_program() -> Outcome {
    let here = Directory::empty("killed")?;
    let mut program = start_long(&here)?;
    kill(&program, Signal::KILL)?;
    program.wait()?;
    assert_eq!(here.files()?.len(), 1);
    here.ok(&arguments("x.png", OLD))?;
    assert_eq!(here.files()?, ["x.png"]);
    Ok(())
}

#[test]
fn programs_that_write_the_same_file_leave_a_valid_one() -> Outcome {
    let here = Directory::empty("same")?;
    let mut program = start_long(&here)?;
    // The short run must not remove the temporary file of the long run.
    here.ok(&arguments("x.png", OLD))?;
    let first = fs::read(here.0.join("x.png"))?;
    assert_eq!(here.files()?.len(), 2);
    assert!(program.wait()?.success());
    assert_eq!(here.files()?, ["x.png"]);
    assert!(fs::read(here.0.join("x.png"))? != first);
    Ok(())
}
