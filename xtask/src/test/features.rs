//! Builds of the library with its optional features.

use std::fs;

use anyhow::{Context, Result, ensure};
use embedded_graphics_core::geometry::Size;
use toml::de::{DeTable, DeValue};

use super::lints;
use crate::core::Core;
use crate::firmware::{Firmware, V6M};
use crate::qemu::{Arithmetic, Machine};
use crate::{host, root, scene};

/// Lints the library without optional features, with each alone, and with all, on the host and on
/// the smallest target. Then draws spheres on a plane without optional features.
pub(super) fn check_all() -> Result<()> {
    let features = features()?;
    println!("features: {}", features.join(", "));
    let (none, all) = (String::new(), features.join(","));
    for features in [&none, &all].into_iter().chain(&features) {
        for target in [&[][..], &["--target", V6M]] {
            let selection = ["--no-default-features", "--features", features];
            lints::library(&[&selection, target].concat())?;
        }
    }
    let (machine, scene) = (Machine::of(Core::M3), scene("four_spheres"));
    let minimal = Firmware {
        defaults: false,
        ..machine.rig("headless")
    };
    let compiled = Arithmetic::Fixed.compile(&scene)?;
    let report = machine.draw(&minimal.build(None)?, &compiled, "80x60")?;
    let expected = host::checksum(&scene, Size::new(80, 60))?;
    let drawn = report.result()?.get("checksum")?;
    ensure!(drawn == expected, "checksum {drawn}, expected {expected}");
    Ok(())
}

/// Returns the features in the library's Cargo.toml, without `default`.
fn features() -> Result<Vec<String>> {
    let manifest = fs::read_to_string(root().join("Cargo.toml"))?;
    let manifest = DeTable::parse(&manifest).context("Cargo.toml")?;
    let Some(DeValue::Table(table)) = manifest.get_ref().get("features").map(AsRef::as_ref) else {
        return Ok(Vec::new());
    };
    let names = table.keys().map(|name| name.get_ref().to_string());
    Ok(names.filter(|name| name != "default").collect())
}
