//! Proof by the linker that the library cannot panic: see `tests/rigs/nopanic`.

use anyhow::{Context, Result, ensure};

use crate::command::cargo;
use crate::firmware::{Firmware, PROFILE, V6M, V7EM, V7M};

/// Linker error for the undefined function that the rig's panic handler calls.
const ERROR: &str = "undefined symbol: something_may_panic";

/// Links the library without any panic for three instruction sets.
pub(crate) fn link_all() -> Result<()> {
    [V6M, V7M, V7EM].into_iter().try_for_each(|target| {
        let linked = Firmware::new("nopanic", target).build(None);
        linked
            .map(drop)
            .with_context(|| format!("the library may panic on {target}"))
    })
}

/// Checks that a panic is found: an index that may be out of bounds must not link.
pub(crate) fn link_broken() -> Result<()> {
    let mut broken = cargo();
    broken.args(["build", "--quiet", "--profile", PROFILE, "--target", V7M]);
    broken.args(["--package", "nopanic", "--features", "broken"]);
    let errors = broken.output()?.stderr;
    ensure!(
        String::from_utf8_lossy(&errors).contains(ERROR),
        "nopanic links although an index may be out of bounds"
    );
    Ok(())
}
