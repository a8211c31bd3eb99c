//! Sets `cfg(armv6m)` or `cfg(armv7m)` from the target name, because Rust has no stable
//! `cfg` for these instruction sets.

use std::env;

fn main() {
    println!("cargo::rustc-check-cfg=cfg(armv6m, armv7m)");
    println!("cargo::rerun-if-changed=build.rs");
    let target = env::var("TARGET").unwrap_or_default();
    if target.starts_with("thumbv6m-") {
        println!("cargo::rustc-cfg=armv6m");
    } else if target.starts_with("thumbv7") || target.starts_with("thumbv8m.main") {
        println!("cargo::rustc-cfg=armv7m");
    }
}
