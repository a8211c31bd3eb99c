//! What a frame would take on microcontrollers.

use whitted_sim::cost::{BOARDS, Model, Work};

use crate::number::{duration, two_digits};
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
