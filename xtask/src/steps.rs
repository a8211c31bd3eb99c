use std::time::Instant;

use anyhow::{Result, bail, ensure};

/// Name and function of a step.
pub(crate) type Step = (&'static str, fn() -> Result<()>);

/// Runs the steps whose names contain one of the words, or all steps if there are no words. Prints
/// a summary. After a failed step, the next steps still run. Only a failure of the step `tools`
/// ends the run.
pub(crate) fn run(steps: &[Step], words: &[String]) -> Result<()> {
    let mut selected = steps.to_vec();
    selected.retain(|(name, _)| words.is_empty() || words.iter().any(|word| name.contains(word)));
    let names: Vec<_> = steps.iter().map(|(name, _)| *name).collect();
    ensure!(
        !selected.is_empty(),
        "unknown step; there are {}",
        names.join(", ")
    );
    let (mut summary, mut failed) = (String::new(), Vec::new());
    for (name, step) in selected {
        println!("==> {name}");
        let start = Instant::now();
        let result = step();
        let seconds = start.elapsed().as_secs_f32();
        let outcome = if result.is_ok() { "ok" } else { "FAILED" };
        println!("<== {name}: {outcome}, {seconds:.1} s");
        summary += &format!("  {name:14} {outcome:8} {seconds:6.1} s\n");
        if let Err(error) = result {
            eprintln!("error: {error:#}");
            failed.push(name);
            if name == "tools" {
                break;
            }
        }
    }
    print!("\nsummary\n{summary}");
    if !failed.is_empty() {
        bail!("failed: {}", failed.join(", "));
    }
    Ok(())
}
