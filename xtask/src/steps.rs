//! Running steps one after the other, and summing them up.

use std::time::{Duration, Instant};

use anyhow::{Result, bail};

/// A name, and what to do.
pub(crate) type Step = (&'static str, fn() -> Result<()>);

/// Runs the steps whose names contain one of the words, or all. A step that
/// fails does not keep the ones after it from running, but for the tools.
pub(crate) fn run(steps: &[Step], words: &[String]) -> Result<()> {
    let chosen = |name: &str| words.is_empty() || words.iter().any(|word| name.contains(word));
    let mut summary = Vec::new();
    for (name, step) in steps {
        if !chosen(name) {
            summary.push((name, "not run", Duration::ZERO));
            continue;
        }
        println!("==> {name}");
        let start = Instant::now();
        let outcome = match step() {
            Ok(()) => "ok",
            Err(error) => {
                eprintln!("error: {error:#}");
                "FAILED"
            }
        };
        let time = start.elapsed();
        println!("<== {name}: {outcome}, {:.1} s", time.as_secs_f32());
        summary.push((name, outcome, time));
        // Nothing works without the tools.
        if *name == "tools" && outcome != "ok" {
            break;
        }
    }
    println!("\nsummary");
    for (name, outcome, time) in &summary {
        println!("  {name:12} {outcome:8} {:6.1} s", time.as_secs_f32());
    }
    if summary.iter().any(|(_, outcome, _)| *outcome == "FAILED") {
        bail!("not all steps passed");
    }
    if !summary.iter().any(|(_, outcome, _)| *outcome == "ok") {
        bail!("no step has such a name");
    }
    Ok(())
}
