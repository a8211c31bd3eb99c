//! Estimated frame times on microcontrollers.

use std::io::Write;

use whitted_sim::cost::{BOARDS, Work};

use crate::console::Console;
use crate::number::{duration, two_digits};
use crate::outcome::Outcome;

/// Prints an estimate for each board.
pub(crate) fn print(mut console: Console, work: &Work) -> Outcome {
    writeln!(
        console,
        "estimates, without display transfer and flash wait states (docs/cost-model.md):"
    )?;
    for board in BOARDS {
        let place = format!(
            "{} at {} MHz ({})",
            board.title, board.megahertz, board.chip
        );
        writeln!(
            console,
            "  on a {place:33} about {:>6} {:>6} M instructions",
            duration(board.seconds(work)),
            two_digits(board.instructions(work) / 1e6),
        )?;
    }
    Ok(())
}
