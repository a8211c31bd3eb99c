//! Estimated frame times on microcontrollers.

use whitted_sim::cost::{BOARDS, Work};

use crate::number::{duration, two_digits};

/// Prints an estimate for each board.
pub(crate) fn print(work: &Work) {
    println!("estimates, without display transfer and flash wait states (docs/cost-model.md):");
    for board in BOARDS {
        let place = format!(
            "{} at {} MHz ({})",
            board.title, board.megahertz, board.chip
        );
        println!(
            "  on a {place:33} about {:>6} {:>6} M instructions",
            duration(board.seconds(work)),
            two_digits(board.instructions(work) / 1e6),
        );
    }
}
