//! Runs the program with limits for time and memory.

use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use crate::Outcome;

/// Longest time of a command. A command usually takes some milliseconds, but the machine may be busy.
const TIMEOUT: Duration = Duration::from_secs(60);

/// Largest address space of a command, in KiB.
const MEMORY: u32 = 512 * 1024;

/// Longest message, in bytes.
const MESSAGE: usize = 4000;

/// The program in a directory of its own.
pub(crate) struct Program(PathBuf);

impl Program {
    pub(crate) fn new(thread: usize) -> Outcome<Self> {
        let name = format!("mutations-{thread}");
        let directory = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
        fs::create_dir_all(&directory)?;
        Ok(Self(directory))
    }

    /// Runs all commands that read scene files. Returns true if the scene is valid.
    pub(crate) fn scene(&self, text: &[u8]) -> Outcome<bool> {
        fs::write(self.0.join("a.toml"), text)?;
        self.commands("a.toml")
    }

    /// Runs all commands that read compiled scenes. Returns true if the scene is valid.
    pub(crate) fn compiled(&self, bytes: &[u8]) -> Outcome<bool> {
        fs::write(self.0.join("a.scene"), bytes)?;
        self.commands("a.scene")
    }

    /// Compares a picture with valid pictures, and with itself. Returns true if the picture is
    /// valid.
    pub(crate) fn pictures(&self, picture: &[u8], valid: &[Vec<u8>]) -> Outcome<bool> {
        fs::write(self.0.join("a.png"), picture)?;
        for other in valid {
            fs::write(self.0.join("b.png"), other)?;
            self.run(&["compare", "a.png", "b.png"])?;
        }
        self.run(&["compare", "a.png", "a.png"])
    }

    /// Runs all commands that read scenes. All must succeed if `check` succeeds.
    fn commands(&self, scene: &str) -> Outcome<bool> {
        let is_valid = self.run(&["check", scene])?;
        let small = ["--size", "6x4", "--max-depth", "4"];
        let film = ["--frames", "3", "-o", "b.gif"];
        let commands = [
            vec!["compile", scene, "-o", "b.scene"],
            [&["render", scene, "-o", "b.png"][..], &small].concat(),
            [&["explain", scene, "3", "2"][..], &small].concat(),
            [&["animate", scene][..], &small, &film].concat(),
        ];
        for command in commands {
            let is_film_of_compiled = command.contains(&"animate") && scene.ends_with(".scene");
            if !self.run(&command)? && is_valid && !is_film_of_compiled {
                return Err(format!("`check` succeeds, but {command:?} fails").into());
            }
        }
        Ok(is_valid)
    }

    /// Runs a command. Returns true if it succeeds, and false if it reports an error.
    fn run(&self, arguments: &[&str]) -> Outcome<bool> {
        let limited = format!("ulimit -v {MEMORY}; exec \"$@\"");
        let output = self.0.join("output");
        let file = File::create(&output)?;
        let mut child = Command::new("sh")
            .args(["-c", &limited, "sh", env!("CARGO_BIN_EXE_sim")])
            .args(arguments)
            .current_dir(&self.0)
            .stdin(Stdio::null())
            .stdout(file.try_clone()?)
            .stderr(file)
            .spawn()?;
        let status = wait(&mut child)?;
        let text = fs::read_to_string(&output)?;
        let describe = |problem: &str| {
            let start: String = text.chars().take(MESSAGE).collect();
            format!(
                "{arguments:?} in {}: {problem}: {start:?}",
                self.0.display()
            )
        };
        if text.len() > MESSAGE && !arguments.contains(&"explain") {
            return Err(describe("long message").into());
        }
        if text.contains(|c: char| c.is_control() && c != '\n') {
            return Err(describe("control characters").into());
        }
        match status.and_then(|status| status.code()) {
            Some(0) => Ok(true),
            Some(2) if text.starts_with("error: ") => Ok(false),
            _ => Err(describe(&format!("ends with {status:?}")).into()),
        }
    }
}

/// Waits for a process. If it takes too long, ends it and returns `None`.
fn wait(child: &mut Child) -> Outcome<Option<ExitStatus>> {
    let start = Instant::now();
    while start.elapsed() < TIMEOUT {
        if let Some(status) = child.try_wait()? {
            return Ok(Some(status));
        }
        sleep(Duration::from_millis(1));
    }
    child.kill()?;
    child.wait()?;
    Ok(None)
}
