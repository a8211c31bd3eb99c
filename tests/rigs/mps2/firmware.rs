//! Build script of all firmware for the mps2 boards.
//!
//! Defines the linker symbol `an505` for Armv8-M targets, so that `memory.x` selects the
//! memory map of the mps2-an505.

use std::env;

fn main() {
    println!("cargo::rerun-if-changed=../../../memory.x");
    if env::var("TARGET").is_ok_and(|target| target.starts_with("thumbv8m")) {
        println!("cargo::rustc-link-arg-bins=--defsym=an505=1");
    }
}
