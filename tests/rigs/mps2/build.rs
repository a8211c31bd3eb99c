//! Sets `cfg(an505)` for Armv8-M targets: the mps2-an505 is the only supported
//! Armv8-M board.

use std::env;

fn main() {
    println!("cargo::rustc-check-cfg=cfg(an505)");
    println!("cargo::rerun-if-changed=../../../memory.x");
    if env::var("TARGET").is_ok_and(|target| target.starts_with("thumbv8m")) {
        println!("cargo::rustc-cfg=an505");
    }
}
