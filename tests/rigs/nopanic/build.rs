//! Defines the linker symbol `link_only`, so that `memory.x` has room for every public function.
//! The firmware is linked but never run, so it may exceed the flash of the machines in QEMU.

fn main() {
    println!("cargo::rerun-if-changed=../../../memory.x");
    println!("cargo::rustc-link-arg-bins=--defsym=link_only=1");
}
