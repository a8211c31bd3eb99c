use anyhow::Result;

use crate::command::{cargo_of, run};
use crate::tools::require;

/// A big-endian target.
const MIPS: &str = "mips-unknown-linux-gnu";

/// Tests that do not run in Miri, because they would take hours there.
const SLOW: [&str; 4] = ["budget", "error_bounds", "sixteen_bits", "srgb_is_within"];

/// Runs the library's unit tests and `tests/everywhere` in Miri, on the host and on a big-endian
/// target.
pub(super) fn check() -> Result<()> {
    require(
        &["cargo", "+nightly", "miri"],
        "rustup toolchain install nightly --component miri rust-src",
    )?;
    for target in [&[][..], &["--target", MIPS]] {
        let mut miri = cargo_of("+nightly", "miri");
        miri.args(["miri", "test", "--package", "whitted"]);
        miri.args(["--lib", "--test", "everywhere"]).args(target);
        miri.arg("--")
            .args(SLOW.map(|test| format!("--skip={test}")));
        run(&mut miri)?;
    }
    Ok(())
}
