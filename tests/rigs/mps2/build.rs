//! Tells the boards apart by the target: only the an505 has a core of ARMv8-M.

use std::env;

fn main() {
    println!("cargo::rustc-check-cfg=cfg(an505)");
    println!("cargo::rerun-if-changed=../../../memory.x");
    if env::var("TARGET").is_ok_and(|target| target.starts_with("thumbv8m")) {
        println!("cargo::rustc-cfg=an505");
    }
}
