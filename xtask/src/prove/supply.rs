//! Checks the dependencies and the package to publish.

use std::{fs, iter};

use anyhow::{Result, ensure};

use crate::board;
use crate::command::{cargo, cargo_of, run};
use crate::firmware::V6M;
use crate::tools::require;
use crate::{root, scratch_dir};

/// Oldest supported toolchain. This is the `rust-version` in Cargo.toml.
const OLDEST: &str = "+1.89";

/// Oldest version of the crate `fixed` that Cargo.toml allows. It is the first with `lit`.
const OLDEST_FIXED: &str = "1.22.0";

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
    run(cargo_of(OLDEST, "oldest").args(["check", "--quiet", "--package", "whitted"]))?;
    range_of_fixed()
}

/// Checks that a program can use the library with the oldest and the newest version of `fixed` that
/// Cargo.toml allows. `Real` is a type of that crate, so the program and the library must use the
/// same version.
fn range_of_fixed() -> Result<()> {
    let folder = scratch_dir()?.join("fixed");
    fs::create_dir_all(folder.join("src"))?;
    fs::write(folder.join("src/lib.rs"), "#![no_std]")?;
    let whitted = root().display();
    let manifest = format!(
        "[package]\nname = \"user\"\nedition = \"2024\"\n\
         [dependencies]\nwhitted = {{ path = '{whitted}' }}\n[workspace]\n"
    );
    fs::write(folder.join("Cargo.toml"), manifest)?;
    for version in [&["--precise", OLDEST_FIXED][..], &[]] {
        let mut update = cargo();
        update.current_dir(&folder).args(["update", "--quiet"]);
        run(update.args(["--package", "fixed"]).args(version))?;
        run(cargo().current_dir(&folder).args(["check", "--quiet"]))?;
    }
    Ok(())
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
