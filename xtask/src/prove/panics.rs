//! No panic, proven by the linker: see boards/nopanic.

use anyhow::{Context, Result, ensure};

use crate::command::cargo;
use crate::firmware::{PROFILE, V6M, V7EM, V7M, nopanic};

/// What links only where nothing may panic.
const TARGETS: [&str; 3] = [V6M, V7M, V7EM];

/// What the panic handler calls, and nothing defines.
const SYMBOL: &str = "undefined symbol: something_may_panic";

/// Links the whole library for each instruction set.
pub(crate) fn link_all() -> Result<()> {
    TARGETS.into_iter().try_for_each(|target| {
        let linked = nopanic(target).build(None).map(drop);
        linked.with_context(|| format!("something may panic on {target}"))
    })
}

/// The same, and sees that a single panic would not link.
pub(super) fn prove() -> Result<String> {
    link_all()?;
    let mut broken = cargo();
    broken.args(["build", "--quiet", "--profile", PROFILE, "--target", V7M]);
    broken.args(["--package", "nopanic", "--features", "broken"]);
    let output = broken.output()?;
    let complaint = String::from_utf8_lossy(&output.stderr);
    ensure!(
        complaint.contains(SYMBOL),
        "an index out of bounds links, so this proves nothing"
    );
    Ok(format!(
        "links for {}; with one index that may be out of bounds it does not",
        TARGETS.join(", ")
    ))
}
