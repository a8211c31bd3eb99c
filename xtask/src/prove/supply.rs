//! Checks the dependencies and the package to publish.

use std::iter;

use anyhow::{Result, ensure};

use crate::board;
use crate::command::{cargo, cargo_of, run};
use crate::firmware::V6M;
use crate::root;
use crate::tools::require;

/// Oldest supported toolchain. This is the `rust-version` in Cargo.toml.
const OLDEST: &str = "+1.89";

pub(super) fn check() -> Result<()> {
    require(&["cargo", "deny"], "cargo install cargo-deny")?;
    let apart = ["tests/rigs/virt", "fuzz"].map(|folder| root().join(folder));
    let folders = iter::once(root().to_owned()).chain(board::folders());
    for folder in folders.chain(apart) {
        println!("{}", folder.display());
        let mut deny = cargo();
        deny.current_dir(&folder);
        deny.args(["deny", "--log-level=error", "--workspace", "--config"]);
        deny.arg(root().join("deny.toml"));
        run(deny.args(["check", "licenses", "bans", "sources"]))?;
    }
    no_duplicates()?;
    // cargo-deny downloads its database of security advisories. The download fails without a
    // network.
    match run(cargo().args(["deny", "fetch", "db"])) {
        Ok(()) => run(cargo().args(["deny", "check", "advisories"]))?,
        Err(_) => println!("advisories are not checked without a network"),
    }
    // Cargo packages `long-multiply` and `whitted` together, because `whitted` depends on
    // `long-multiply`.
    let mut package = cargo();
    package.args(["package", "--quiet", "--allow-dirty"]);
    run(package.args(["--package", "long-multiply", "--package", "whitted"]))?;

    require(&["cargo", OLDEST], "rustup toolchain install 1.89")?;
    run(cargo_of(OLDEST, "oldest").args(["check", "--quiet", "--package", "whitted"]))
}

/// Returns an error if the library depends on more than one version of the same crate.
fn no_duplicates() -> Result<()> {
    let mut tree = cargo();
    tree.args(["tree", "--duplicates", "--package", "whitted"]);
    let output = tree.args(["--edges", "normal", "--target", V6M]).output()?;
    let duplicates = String::from_utf8_lossy(&output.stdout);
    ensure!(
        output.status.success() && duplicates.is_empty(),
        "the library depends on two versions of a crate:\n{duplicates}"
    );
    Ok(())
}
