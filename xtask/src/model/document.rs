//! The document about the model.

use std::fmt::{self, Write};

use whitted_sim::cost::{BOARDS, ITEMS};

use super::count::COUNTED;
use super::fit::{Fit, Trial};
use super::mix::Mix;
use super::thumb::Class;
use crate::qemu::Core;

const INTRODUCTION: &str = "\
# What a frame will take

Written by `cargo xtask fit`, with TOOLCHAIN; not to be edited.

`cargo sim render SCENE --stats` says how long a frame would take on microcontrollers. Three things are multiplied:

1. **What the frame asks for**: rays, tests, hits. This machine counts it while it renders, exactly, as every target
   draws the same bits (`whitted_sim::cost::Work`, an `Observer`).
2. **Instructions for each**: the table of prices, in `sim/cost.toml`. They are fitted, by non-negative least squares
   of relative errors, to the instructions that QEMU counts for the frames of all of `scenes/` and of random scenes.
3. **Cycles for an instruction**, and the clock. This is an estimate: no hardware was at hand.
";

const PRICES: &str = "
## Prices

Instructions for one of each. Items that always come together share their price in a way that only the sum of them
is sure; an item of 0 is paid for by others. The Cortex-M7 runs the code of the M4F.

";

const TRIALS: &str = "
## How good it is

Each scene is predicted, at 160x120, by prices that were fitted without it, and compared with what QEMU counts; with it,
as `cargo sim` does, it is off by less. *Random* scenes are rooms, crowds of balls, and odd things: a camera within a
glass cone, cylinders without end. A shininess with a fraction takes up to 16 roots for each highlight, which no price
tells; the random scenes have whole ones.

";

const CYCLES: &str = "
## Cycles

Instructions were logged (`four_spheres` and `every_surface`, 16x12) and sorted into classes, each with the cycles that
the core's technical reference manual gives it: on the Cortex-M0+ loads and stores take 2, a taken branch 2, `MULS` 1; on
the M3 and M4 a load 2, a taken branch 1 and 1 to 3 for the pipeline, a long product 3 to 5 on the M3 and 1 on the M4.
Arm gives no timings for the M7 and M33, so theirs are the M4's, scaled by CoreMark per MHz (3.42, 5.01, 4.02).

Not in it: wait states and caches of flash, which may well double the time of code that runs from it, memory that
others use at the same time, and the transfer to the display.

";

/// The document.
pub(super) fn write(fit: &Fit, mixes: &[(Core, Mix)]) -> Result<String, fmt::Error> {
    let mut text = INTRODUCTION.replace("TOOLCHAIN", &fit.model.toolchain);
    prices(&mut text, fit)?;
    trials(&mut text, &fit.trials)?;
    cycles(&mut text, fit, mixes)?;
    Ok(text)
}

fn titles() -> String {
    COUNTED.map(Core::title).join(" | ")
}

fn prices(text: &mut String, fit: &Fit) -> fmt::Result {
    text.push_str(PRICES);
    writeln!(text, "| item | {} |\n|---|--:|--:|--:|--:|", titles())?;
    for (index, item) in ITEMS.iter().enumerate() {
        write!(text, "| {} |", item.title)?;
        for core in COUNTED {
            let core = fit.model.core(&core.to_string());
            let price = core.map_or(0.0, |core| core.instructions[index]);
            write!(text, " {price:.0} |")?;
        }
        text.push('\n');
    }
    Ok(())
}

fn trials(text: &mut String, trials: &[Trial]) -> fmt::Result {
    text.push_str(TRIALS);
    writeln!(text, "| scene | {} |\n|---|--:|--:|--:|--:|", titles())?;
    let shipped = || trials.iter().filter(|trial| trial.is_shipped);
    let names = shipped().filter(|trial| trial.core == COUNTED[0]);
    for name in names.map(|trial| &trial.name) {
        write!(text, "| `{name}` |")?;
        for trial in shipped().filter(|trial| trial.name == *name) {
            write!(text, " {:+.1} % |", 100.0 * trial.error())?;
        }
        text.push('\n');
    }
    let mean = |errors: &[f64]| percent(errors.iter().sum::<f64>() / errors.len() as f64);
    let worst = |errors: &[f64]| percent(errors.iter().copied().fold(0.0, f64::max));
    let within = |errors: &[f64]| {
        let good = errors.iter().filter(|error| **error < 0.1);
        format!("{} of {}", good.count(), errors.len())
    };
    let (shipped, random) = (
        |trial: &Trial| trial.is_shipped,
        |trial: &Trial| trial.name.starts_with("random"),
    );
    summary(text, "of these, the mean", trials, shipped, mean)?;
    summary(text, "of these, the worst", trials, shipped, worst)?;
    summary(text, "of random scenes, the mean", trials, random, mean)?;
    summary(text, "random scenes within 10 %", trials, random, within)
}

fn percent(share: f64) -> String {
    format!("{:.1} %", 100.0 * share)
}

/// A line of what there is to say of the errors of such scenes, on each core.
fn summary(
    text: &mut String,
    title: &str,
    trials: &[Trial],
    is_such: impl Fn(&Trial) -> bool,
    say: impl Fn(&[f64]) -> String,
) -> fmt::Result {
    write!(text, "| {title} |")?;
    for core in COUNTED {
        let such = trials.iter().filter(|trial| trial.core == core);
        let errors: Vec<_> = such
            .filter(|trial| is_such(trial))
            .map(|trial| trial.error().abs())
            .collect();
        write!(text, " {} |", say(&errors))?;
    }
    text.push('\n');
    Ok(())
}

fn cycles(text: &mut String, fit: &Fit, mixes: &[(Core, Mix)]) -> fmt::Result {
    text.push_str(CYCLES);
    writeln!(
        text,
        "| core | loads | stores | long products | taken branches |\n|---|--:|--:|--:|--:|"
    )?;
    for (core, mix) in mixes {
        let loads = mix.share(|class, _| matches!(class, Class::Load | Class::LoadMany(_)));
        let stores = mix.share(|class, _| matches!(class, Class::Store | Class::StoreMany(_)));
        let long =
            mix.share(|class, _| matches!(class, Class::LongMultiply | Class::LongMultiplyAdd));
        let taken = mix.share(|_, is_taken| is_taken);
        let shares = [loads, stores, long, taken].map(|share| format!("{:.0} %", 100.0 * share));
        writeln!(text, "| {} | {} |", core.title(), shares.join(" | "))?;
    }
    writeln!(
        text,
        "\n| core | cycles an instruction | clock | chip with such a clock |\n|---|--:|--:|---|"
    )?;
    for board in BOARDS {
        let core = fit.model.core(board.core);
        let cycles = core.map_or(0.0, |core| core.cycles);
        let (title, clock, chip) = (board.title, board.megahertz, board.chip);
        writeln!(text, "| {title} | {cycles:.2} | {clock} MHz | {chip} |")?;
    }
    Ok(())
}
