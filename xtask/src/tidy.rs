//! Checks rules of the source code that Clippy cannot check.

mod callers;
mod cycles;
mod layers;
mod modules;
mod names;
mod source;
mod test_modules;
mod words;

use std::fs;
use std::path::PathBuf;

use anyhow::{Context, Result, bail, ensure};

use crate::command::command;
use crate::root;
use modules::Crate;
use source::Source;

/// Checks all rules for the source code and prints every violation.
pub fn run() -> Result<()> {
    let mut violations = Vec::new();
    let mut sources = Vec::new();
    for path in committed_files()? {
        // A file that is not UTF-8 is not text, so it has no words to check.
        let Ok(text) = String::from_utf8(fs::read(root().join(&path))?) else {
            continue;
        };
        violations.extend(words::check(&path, &text));
        if path.extension().is_some_and(|extension| extension == "rs") {
            sources.push(Source::parse(&path, &text)?);
        }
    }
    let page = fs::read_to_string(root().join("docs/architecture.md"))?;
    violations.extend(layers::check(&Crate::new("src", &sources), &page));
    violations.extend(callers::check(&sources));
    violations.extend(test_modules::check(&sources));
    for folder in ["src", "sim/src", "sim/src/bin/sim", "xtask/src"] {
        violations.extend(cycles::check(&Crate::new(folder, &sources)));
    }
    for violation in &violations {
        eprintln!("{violation}");
    }
    if !violations.is_empty() {
        bail!("{} violations", violations.len());
    }
    Ok(())
}

/// Returns the paths of all files in the project that Git does not ignore.
fn committed_files() -> Result<Vec<PathBuf>> {
    let mut git = command("git");
    git.args([
        "ls-files",
        "-z",
        "--cached",
        "--others",
        "--exclude-standard",
    ]);
    let output = git.output().context("cannot start git")?;
    let errors = String::from_utf8_lossy(&output.stderr);
    ensure!(output.status.success(), "git failed: {errors}");
    let list = String::from_utf8(output.stdout)?;
    let files = list.split_terminator('\0').map(PathBuf::from);
    // Git still lists deleted files until their deletion is committed. Leaves out these files.
    Ok(files.filter(|path| root().join(path).is_file()).collect())
}
