//! Checks builds of the library with different optional features.

use std::fs;

use anyhow::{Context, Result};
use toml::de::{DeTable, DeValue};

use super::lints;
use crate::command::{self, cargo};
use crate::firmware::V6M;
use crate::root;

/// The library is not optimized for the tests of features, because they draw only small pictures.
const NOT_OPTIMIZED: [&str; 2] = ["--config", "profile.dev.package.whitted.opt-level=0"];

/// Lints the library for the smallest target and runs the tests of features. Does this without
/// optional features, with all features, and with each feature alone.
pub(super) fn check_all() -> Result<()> {
    let features = features()?;
    println!("features: {}", features.join(", "));
    let (none, all) = (String::new(), features.join(","));
    for features in [&none, &all].into_iter().chain(&features) {
        let selection = selection(features);
        lints::library(&[&selection[..], &["--target", V6M]].concat())?;
        let mut test = cargo();
        test.args(["test", "--quiet", "--package", "feature-tests"]);
        command::run(test.args(NOT_OPTIMIZED).args(selection))?;
    }
    Ok(())
}

fn selection(features: &str) -> [&str; 3] {
    ["--no-default-features", "--features", features]
}

/// Returns the names of the features in the library's Cargo.toml, without `default`.
fn features() -> Result<Vec<String>> {
    let manifest = fs::read_to_string(root().join("Cargo.toml"))?;
    let manifest = DeTable::parse(&manifest).context("Cargo.toml")?;
    let Some(DeValue::Table(table)) = manifest.get_ref().get("features").map(AsRef::as_ref) else {
        return Ok(Vec::new());
    };
    let names = table.keys().map(|name| name.get_ref().to_string());
    Ok(names.filter(|name| name != "default").collect())
}
