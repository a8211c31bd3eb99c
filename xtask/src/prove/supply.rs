//! What is published, and what it rests on.

use anyhow::Result;

use super::tools::{self, OLDEST};
use crate::command::{cargo, command, run};
use crate::target_dir;

pub(super) fn prove() -> Result<String> {
    tools::subcommand("deny")?;
    run(cargo().args(["deny", "check", "licenses", "bans", "sources"]))?;
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
        "licenses, sources and duplicates in order, {advisories}; both packages build as packed; Rust {} builds them",
        OLDEST.trim_start_matches('+')
    ))
}

fn oldest() -> Result<()> {
    tools::toolchain(OLDEST, "toolchain install 1.89")?;
    let mut check = command("cargo");
    check.args([OLDEST, "check", "--quiet", "--package", "whitted"]);
    check.env("CARGO_TARGET_DIR", target_dir().join("oldest"));
    check.env_remove("RUSTUP_TOOLCHAIN").env_remove("CARGO");
    run(check.env_remove("RUSTC"))
}
