//! The tables for people.

use std::collections::BTreeMap;
use std::fmt::Write;

use super::count::Row;
use super::flash::Code;
use crate::qemu::Core;

/// What the usual ray tracer for microcontrollers takes for the four spheres
/// at 320x240: C++, floats, by gcc 12 at -O2; with the FPU the M4F's code. It
/// stands in the yardstick's place where it takes less.
const USUAL_TRACER: [(Core, u64); 5] = [
    (Core::M0, 2_504_000_000),
    (Core::M3, 1_177_000_000),
    (Core::M4f, 61_100_000),
    (Core::M7, 61_100_000),
    (Core::M33, 61_100_000),
];

const INTRODUCTION: &str = "\
# Benchmarks

Written by `cargo xtask bench`, with TOOLCHAIN; not to be edited.

Instructions of a frame, counted by QEMU (`-icount`): the compiled scene is decoded, then drawn line by line to an
`Rgb565` display that throws its pixels away. They are the same in every run, and the picture is checked to be that
of this machine, bit for bit. A query is an eye, reflected, transmitted or shadow ray.

*float* is the same scene, size, core and display in plain `f32` ([`tests/rigs/float`](../tests/rigs/float)): floats and
roots in hardware on the M4F, M7 and M33, by Rust's own routines on the M0+ and M3. There it is counted at half the
width and height, at a quarter for the sphereflake, and scaled by the pixels. *times* is how many times the
instructions of the fixed point that takes; below 1, floats win.
";

const USUAL: &str = "\
\\* For this scene the usual C++ ray tracer for microcontrollers, in floats, by gcc 12 at `-O2`, stands in place of
the yardstick, as it takes less. So elsewhere, too, floats could take less than *float* says. The yardstick's own:
";

const FLAKE: &str = "\
Not arithmetic alone: *float* skips each subtree that a ray misses, but does not visit the nearest first.
";

/// The document.
pub(crate) fn write(rows: &[Row], code: &BTreeMap<Core, Code>, toolchain: &str) -> String {
    let mut text = INTRODUCTION.replace("TOOLCHAIN", toolchain);
    let is_same = |a: &Row, b: &Row| (a.scene, &a.size) == (b.scene, &b.size);
    for group in rows.chunk_by(is_same) {
        // Writing to a string cannot fail.
        _ = table(&mut text, group);
    }
    _ = sizes(&mut text, rows, code);
    text
}

fn table(text: &mut String, rows: &[Row]) -> std::fmt::Result {
    let Some(first) = rows.first() else {
        return Ok(());
    };
    let (scene, size) = (first.scene, &first.size);
    writeln!(text, "\n## `{scene}`, {size}\n")?;
    writeln!(text, "{} queries.\n", thousands(first.queries))?;
    writeln!(
        text,
        "| core | instructions | a pixel | a query | float | times | stack |"
    )?;
    writeln!(text, "|---|--:|--:|--:|--:|--:|--:|")?;
    for row in rows {
        let (float, mark) = float(row);
        writeln!(
            text,
            "| {} | {} | {} | {} | {}{mark} | {:.2} | {} |",
            row.core.title(),
            millions(row.instructions),
            thousands(row.instructions / row.pixels.max(1)),
            thousands(row.instructions / row.queries.max(1)),
            millions(float),
            float as f64 / row.instructions as f64,
            thousands(row.stack),
        )?;
    }
    if rows.iter().any(|row| !float(row).1.is_empty()) {
        let own = rows.iter().filter_map(|row| {
            let count = row.float_instructions?;
            Some(format!("{} {}", row.core, millions(count)))
        });
        write!(text, "\n{USUAL}{}.\n", own.collect::<Vec<_>>().join(", "))?;
    }
    if scene == "sphereflake" {
        write!(text, "\n{FLAKE}")?;
    }
    Ok(())
}

/// What fixed point is compared with, and the mark of what is not the yardstick.
fn float(row: &Row) -> (u64, &'static str) {
    let own = row.float_instructions.unwrap_or_default();
    let is_usual = row.scene == "four_spheres" && row.size == "320x240";
    let usual = USUAL_TRACER
        .iter()
        .find_map(|(core, count)| (*core == row.core && *count < own).then_some(*count));
    match usual {
        Some(usual) if is_usual => (usual, " \\*"),
        _ => (own, ""),
    }
}

fn sizes(text: &mut String, rows: &[Row], code: &BTreeMap<Core, Code>) -> std::fmt::Result {
    writeln!(
        text,
        "\n## Flash and RAM\n\n\
         In bytes. The library's code is all machine code that comes of a line of `src`, the number\n\
         formats inlined there included, constants not: what draws, all features included, and what only\n\
         reading compiled scenes calls, with its checks and error texts. The firmware has semihosting and\n\
         formatted output besides. The RAM is room for 64 objects, 8 lights and 64 materials, and the\n\
         renderer's 0.7 KB, which are static, so that the stack holds calls alone.\n\n\
         | core | the library draws | and reads scenes | firmware | RAM |\n|---|--:|--:|--:|--:|"
    )?;
    for (core, code) in code {
        if let Some(row) = rows.iter().find(|row| row.core == *core) {
            writeln!(
                text,
                "| {} | {} | {} | {} | {} |",
                core.title(),
                thousands(code.drawing),
                thousands(code.reading),
                thousands(row.flash),
                thousands(row.ram),
            )?;
        }
    }
    Ok(())
}

/// `12345678` as `12.3 M`.
pub(crate) fn millions(count: u64) -> String {
    let millions = count as f64 / 1e6;
    if millions < 100.0 {
        format!("{millions:.1} M")
    } else {
        format!("{} M", thousands(millions.round() as u64))
    }
}

/// `12345678` as `12,345,678`.
pub(crate) fn thousands(count: u64) -> String {
    let digits = count.to_string();
    let mut text = String::new();
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_easy_to_read() {
        assert_eq!(
            [7, 1234, 1_234_567].map(thousands),
            ["7", "1,234", "1,234,567"]
        );
        assert_eq!(
            [61_100_000, 1_177_000_000].map(millions),
            ["61.1 M", "1,177 M"]
        );
    }
}
