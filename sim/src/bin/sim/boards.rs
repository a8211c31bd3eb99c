//! Estimates of frame times on microcontrollers.

use whitted_sim::cost::{BOARDS, Model, Work};

use crate::number::{duration, two_digits};
use crate::outcome::Outcome;

/// Prints an estimate for each core, at the clock rate of a chip with that core.
pub(crate) fn print(work: &Work) -> Outcome {
    let model = Model::committed()?;
    println!("estimates, without display driver and flash wait states (docs/cost-model.md):");
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
