//! The section for people.

use std::fmt::Write;

use super::{PLOT, Row};
use crate::bench::document::{millions, thousands};

const INTRODUCTION: &str = "\
## More spheres

Instructions of a frame of 320x240 on the Cortex-M3, of 1 to 256 equal spheres in a square grid that fills the view
before a plain background; written by `cargo xtask bench --growth`. Their radius is 0.4 of their row's height, so
whatever their number they cover two fifths of the picture; *a line* is how many of them a line of pixels shows, on
average. They are lit by one light, have diffuse and Phong terms, cast shadows on each other and reflect each other
twice. *to one* is in one sphere's instructions, and beside it what growth in step with the spheres of a line would
make of them. The buffer of the firmware holds 256 objects, a light and a material.

The last columns say whose the instructions are, by counting the same spheres without a light and without mirrors,
then without mirrors: those of the eye's rays, with the display; of shadow rays and shading; of reflected rays with
their shadow rays.
";

pub(super) fn write(rows: &[Row]) -> String {
    let mut text = INTRODUCTION.to_owned();
    // Writing to a string cannot fail.
    _ = plot_and_table(&mut text, rows);
    text
}

fn plot_and_table(text: &mut String, rows: &[Row]) -> std::fmt::Result {
    let Some(one) = rows.first() else {
        return Ok(());
    };
    writeln!(
        text,
        "\n![Instructions by spheres in view, next to growth in step with the spheres of a line]({PLOT})\n\n\
         | spheres | a line | queries | tests a query | instructions | a pixel | to one | the line's | eye | shadow | reflected |\n\
         |--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|"
    )?;
    for row in rows {
        let [eye, with_shadows, whole] = row.instructions;
        writeln!(
            text,
            "| {} | {:.1} | {} | {:.1} | {} | {} | {:.2} | {:.2} | {} | {} | {} |",
            row.spheres,
            row.per_line,
            thousands(row.queries),
            row.tests as f64 / row.queries as f64,
            millions(whole),
            thousands(whole / (320 * 240)),
            whole as f64 / one.whole() as f64,
            row.per_line / one.per_line,
            percent(eye, whole),
            percent(with_shadows.saturating_sub(eye), whole),
            percent(whole.saturating_sub(with_shadows), whole),
        )?;
    }
    Ok(())
}

fn percent(part: u64, whole: u64) -> String {
    format!("{:.0} %", 100.0 * part as f64 / whole as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_tells_growth_and_shares() {
        let row = |spheres, per_line, instructions| Row {
            spheres,
            per_line,
            queries: 100,
            tests: 250,
            instructions,
        };
        let rows = [
            row(1, 0.8, [40_000_000, 60_000_000, 80_000_000]),
            row(4, 1.6, [40_000_000, 90_000_000, 100_000_000]),
        ];
        let text = write(&rows);
        let last = "| 4 | 1.6 | 100 | 2.5 | 100 M | 1,302 | 1.25 | 2.00 | 40 % | 50 % | 10 % |\n";
        assert!(text.ends_with(last), "{text}");
    }
}
