//! Proves by linking that the library cannot panic. The firmware is `tests/rigs/nopanic`.

use anyhow::{Context, Result, ensure};

use crate::command::cargo;
use crate::firmware::{Firmware, PROFILE, V6M, V7EM, V7M};

/// Linker error if any code can panic: the panic handler of the firmware calls an undefined
/// function.
const ERROR: &str = "undefined symbol: something_may_panic";

/// Checks for three instruction sets that the library links without a panic handler.
pub(crate) fn link_all() -> Result<()> {
    [V6M, V7M, V7EM].into_iter().try_for_each(|target| {
        let linked = Firmware::new("nopanic", target).build(None);
        linked
            .map(drop)
            .with_context(|| format!("the library may panic on {target}"))
    })
}

/// Checks that the proof finds a panic: an index that may be out of bounds must not link.
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
