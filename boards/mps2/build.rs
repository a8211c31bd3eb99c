//! Chooses the board by the target: only the an505 has a core of ARMv8-M.

use std::env;
use std::path::Path;

/// The linker finds `memory.x` in the folder of the board.
fn main() {
    println!("cargo::rustc-check-cfg=cfg(an505)");
    println!("cargo::rerun-if-changed=memory");

    let is_v8m = env::var("TARGET").is_ok_and(|target| target.starts_with("thumbv8m"));
    let board = if is_v8m {
        println!("cargo::rustc-cfg=an505");
        "an505"
    } else {
        "an385"
    };
    let memory = Path::new(env!("CARGO_MANIFEST_DIR")).join("memory");
    println!("cargo::rustc-link-search={}", memory.join(board).display());
}
