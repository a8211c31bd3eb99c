//! What a frame would take on microcontrollers.

use whitted_sim::cost::{BOARDS, Model, Work};

use crate::outcome::Outcome;

/// Prints an estimate for each core, at the clock of a chip that has it.
pub(crate) fn print(work: &Work) -> Outcome {
    let model = Model::committed()?;
    println!("estimates, without the display's driver and waits for flash (docs/cost-model.md):");
    for board in BOARDS {
        let Some(core) = model.core(board.core) else {
            continue;
        };
        let place = format!(
            "{} at {} MHz ({})",
            board.title, board.megahertz, board.chip
        );
        println!(
            "  on a {place:33} about {:>6} {:>6} M instructions",
            duration(core.seconds(work, &board)),
            two_digits(core.instructions(work) / 1e6),
        );
    }
    Ok(())
}

/// As much of it as an estimate can tell: `3.1 s`, `85 ms`.
fn duration(seconds: f64) -> String {
    if seconds < 0.1 {
        format!("{} ms", two_digits(seconds * 1e3))
    } else {
        format!("{} s", two_digits(seconds))
    }
}

/// A number with its first two digits at least.
fn two_digits(number: f64) -> String {
    let decimals = match number {
        9.95.. => 0,
        0.995.. => 1,
        _ => 2,
    };
    format!("{number:.decimals$}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn durations_are_as_long_as_they_are_sure() {
        let texts = [31.4, 9.96, 3.08, 0.304, 0.0514].map(duration);
        assert_eq!(texts, ["31 s", "10 s", "3.1 s", "0.30 s", "51 ms"]);
    }
}
