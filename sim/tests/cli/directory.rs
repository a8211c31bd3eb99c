use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// Result of a test.
pub(crate) type Outcome = Result<(), Box<dyn Error>>;

/// Working directory of one test.
pub(crate) struct Directory(pub(crate) PathBuf);

impl Directory {
    pub(crate) fn new(name: &str) -> Result<Self, Box<dyn Error>> {
        let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
        fs::create_dir_all(&path)?;
        Ok(Self(path))
    }

    /// Creates an empty directory.
    pub(crate) fn empty(name: &str) -> Result<Self, Box<dyn Error>> {
        let directory = Self::new(name)?;
        fs::remove_dir_all(&directory.0)?;
        Self::new(name)
    }

    /// Returns the sorted names of the files in the directory, including hidden files.
    pub(crate) fn files(&self) -> Result<Vec<String>, Box<dyn Error>> {
        let mut names = Vec::new();
        for entry in fs::read_dir(&self.0)? {
            names.push(entry?.file_name().to_string_lossy().into_owned());
        }
        names.sort();
        Ok(names)
    }

    fn run(&self, args: &[&str]) -> Result<Output, Box<dyn Error>> {
        Ok(self.command(args).output()?)
    }

    pub(crate) fn command(&self, args: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_sim"));
        command.args(args).current_dir(&self.0);
        command
    }

    /// Runs the program successfully and returns its output.
    pub(crate) fn ok(&self, args: &[&str]) -> Result<String, Box<dyn Error>> {
        let output = self.run(args)?;
        let error = String::from_utf8(output.stderr)?;
        assert_eq!(
            (output.status.code(), error.as_str()),
            (Some(0), ""),
            "{args:?}"
        );
        Ok(String::from_utf8(output.stdout)?)
    }

    /// Runs the program with exit code 2 and returns its error message.
    pub(crate) fn error(&self, args: &[&str]) -> Result<String, Box<dyn Error>> {
        let output = self.run(args)?;
        let printed = String::from_utf8(output.stdout)?;
        assert_eq!(
            (output.status.code(), printed.as_str()),
            (Some(2), ""),
            "{args:?}"
        );
        Ok(String::from_utf8(output.stderr)?)
    }
}
