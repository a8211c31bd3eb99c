//! The build script of firmware for these boards: tells memory.x which of them it
//! is for. Only the an505 has a core of ARMv8-M.

use std::env;

fn main() {
    println!("cargo::rerun-if-changed=../../../memory.x");
    if env::var("TARGET").is_ok_and(|target| target.starts_with("thumbv8m")) {
        println!("cargo::rustc-link-arg-bins=--defsym=an505=1");
    }
}
