//! What is published, and what it rests on.

use std::iter;
use std::path::PathBuf;

use anyhow::{Result, ensure};

use super::tools::{self, OLDEST};
use crate::board::{self, Board};
use crate::command::{cargo, command, run};
use crate::firmware::V6M;
use crate::{root, target_dir};

pub(super) fn prove() -> Result<String> {
    tools::subcommand("deny")?;
    for folder in workspaces() {
        println!("{}", folder.display());
        let mut deny = cargo();
        deny.current_dir(&folder);
        deny.args(["deny", "--log-level=error", "--workspace", "--config"]);
        deny.arg(root().join("deny.toml"));
        run(deny.args(["check", "licenses", "bans", "sources"]))?;
    }
    no_duplicates()?;
    // The database of advisories is fetched, which not every place allows.
    let advisories = run(cargo().args(["deny", "check", "advisories"]));
    let advisories = match advisories {
        Ok(()) => "no advisory",
        Err(_) => "advisories not looked up",
    };
    // Both at once: the one is checked against the other as it is packed.
    let mut package = cargo();
    package.args(["package", "--quiet", "--allow-dirty"]);
    run(package.args(["--package", "long-multiply", "--package", "whitted"]))?;
    oldest()?;
    Ok(format!(
        "licenses and sources in order in {} workspaces, nothing twice in the library, {advisories}; \
         both packages build as packed; Rust {} checks the library",
        workspaces().count(),
        OLDEST.trim_start_matches('+')
    ))
}

/// The workspace, and what is one of its own.
fn workspaces() -> impl Iterator<Item = PathBuf> {
    let apart = ["tests/rigs/virt", "fuzz"].map(|folder| root().join(folder));
    let boards = board::all().map(Board::folder);
    iter::once(root().to_owned()).chain(boards).chain(apart)
}

/// What goes into firmware goes there once.
fn no_duplicates() -> Result<()> {
    let mut tree = cargo();
    tree.args(["tree", "--duplicates", "--package", "whitted"]);
    tree.args(["--edges", "normal", "--target", V6M]);
    let output = tree.output()?;
    let twice = String::from_utf8_lossy(&output.stdout);
    ensure!(
        output.status.success() && twice.is_empty(),
        "the library depends on two versions of a crate:\n{twice}"
    );
    Ok(())
}

fn oldest() -> Result<()> {
    tools::toolchain(OLDEST, "toolchain install 1.89")?;
    let mut check = command("cargo");
    check.args([OLDEST, "check", "--quiet", "--package", "whitted"]);
    check.env("CARGO_TARGET_DIR", target_dir().join("oldest"));
    check.env_remove("RUSTUP_TOOLCHAIN").env_remove("CARGO");
    run(check.env_remove("RUSTC"))
}
