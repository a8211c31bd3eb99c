//! Proves that the library cannot panic. The firmware `tests/rigs/nopanic` calls the library, and
//! it links only if no code can panic.

use anyhow::{Context, Result, ensure};

use crate::command::cargo;
use crate::firmware::{Firmware, PROFILE, V6M, V7EM, V7M};

/// Linker error if any code can panic. The panic handler of the firmware calls an undefined
/// function, so the firmware does not link if it needs the panic handler.
const ERROR: &str = "undefined symbol: something_may_panic";

/// Checks on three targets that the firmware links, and so that the library cannot panic.
pub(crate) fn link_all() -> Result<()> {
    [V6M, V7M, V7EM].into_iter().try_for_each(|target| {
        let linked = Firmware::new("nopanic", target).build(None);
        linked
            .map(drop)
            .with_context(|| format!("the library may panic on {target}"))
    })
}

/// Checks that the proof can fail. The firmware must not link if it contains an index that may be
/// out of bounds.
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
