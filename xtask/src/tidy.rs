//! The rules of the source code, as far as a machine can hold them.

mod called;
mod layers;
mod names;
mod tokens;
mod words;

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};

use crate::command::command;
use crate::root;
use tokens::Source;

/// Where a rule is broken, and which one.
type Complaint = String;

/// Checks all rules, and fails with every place where one is broken.
pub fn run() -> Result<()> {
    let mut complaints = Vec::new();
    let (mut library, mut callers) = (Vec::new(), Vec::new());
    for path in committed_files()? {
        let bytes = fs::read(root().join(&path))?;
        // Anything else is no text.
        let Ok(text) = String::from_utf8(bytes) else {
            continue;
        };
        complaints.extend(words::check(&path, &text));
        let is_rust = path.extension().is_some_and(|extension| extension == "rs");
        if path.starts_with("src") && is_rust {
            library.push(Source::parse(&path, &text)?);
        } else if path.starts_with("tests/rigs/nopanic/src") && is_rust {
            callers.push(Source::parse(&path, &text)?);
        }
    }
    complaints.extend(library.iter().flat_map(names::check));
    complaints.extend(layers::check(&library));
    complaints.extend(called::check(&library, &callers));
    if complaints.is_empty() {
        return Ok(());
    }
    for complaint in &complaints {
        eprintln!("{complaint}");
    }
    bail!("{} breaches of the rules", complaints.len())
}

/// Files that are committed, or will be.
fn committed_files() -> Result<Vec<PathBuf>> {
    let mut git = command("git");
    git.args([
        "ls-files",
        "-z",
        "--cached",
        "--others",
        "--exclude-standard",
    ]);
    let output = git.output().context("git does not start")?;
    if !output.status.success() {
        bail!("git failed: {}", String::from_utf8_lossy(&output.stderr));
    }
    let list = String::from_utf8(output.stdout)?;
    let names = list.split_terminator('\0').map(PathBuf::from);
    // A deleted file stays in the list until that is committed.
    Ok(names.filter(|path| root().join(path).is_file()).collect())
}

/// `src/shape/sphere.rs` as `["shape", "sphere"]`, `src/lib.rs` as nothing.
fn module_of(path: &Path) -> Vec<String> {
    let inside = path.strip_prefix("src").unwrap_or(path).with_extension("");
    let mut module: Vec<String> = inside
        .iter()
        .map(|name| name.to_string_lossy().into_owned())
        .collect();
    module.pop_if(|last| last == "lib" || last == "mod");
    module
}
