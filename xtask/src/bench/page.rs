//! Writes the tables of docs/benchmarks.md.

use std::fmt::Write;
use std::fs;

use anyhow::{Context, Result};

use super::choices;
use super::count::Row;
use super::flash::Flash;
use crate::root;
use crate::size::Usage;

const FILE: &str = "docs/benchmarks.md";

/// Page with the flash that each choice costs.
pub(super) const FLASH: &str = "docs/flash.md";

/// Writes text to docs/benchmarks.md, see [`replace_in`].
pub(super) fn replace(name: &str, text: &str) -> Result<()> {
    replace_in(FILE, name, text)
}

/// Writes text to a page. The text replaces the lines between the markers `<!-- name -->` and
/// `<!-- /name -->`.
pub(super) fn replace_in(page: &str, name: &str, text: &str) -> Result<()> {
    let file = root().join(page);
    let old = fs::read_to_string(&file)?;
    let new = replaced(&old, name, text)
        .with_context(|| format!("{page} has no lines <!-- {name} --> and <!-- /{name} -->"))?;
    Ok(fs::write(file, new)?)
}

fn replaced(page: &str, name: &str, text: &str) -> Option<String> {
    let (before, rest) = page.split_once(&format!("<!-- {name} -->\n"))?;
    let (_, after) = rest.split_once(&format!("<!-- /{name} -->\n"))?;
    Some(format!(
        "{before}<!-- {name} -->\n{text}<!-- /{name} -->\n{after}"
    ))
}

/// Returns a table of instruction counts for each picture.
pub(super) fn frames(rows: &[Row]) -> Result<String> {
    let mut text = String::new();
    for rows in rows.chunk_by(|a, b| a.subject == b.subject) {
        let [Row { subject, rays, .. }, ..] = rows else {
            continue;
        };
        let name = subject.to_string().replacen(' ', "`, ", 1);
        writeln!(text, "\n### `{name}\n\n{} rays.\n", thousands(*rays))?;
        text += "| core | instructions | per pixel | per ray | float | ratio | stack |\n";
        text += "|---|--:|--:|--:|--:|--:|--:|\n";
        for row in rows {
            let ratio = row.float_instructions as f64 / row.instructions as f64;
            writeln!(
                text,
                "| {} | {} | {} | {} | {} | {ratio:.2} | {} |",
                row.core.title(),
                millions(row.instructions),
                thousands(row.instructions / subject.pixels().max(1)),
                thousands(row.instructions / rays.max(&1)),
                millions(row.float_instructions),
                thousands(row.stack),
            )?;
        }
    }
    Ok(text)
}

/// Returns a table with the flash and RAM of the headless firmware for each core.
pub(super) fn flash(rows: &[Row], flash: &[Flash]) -> Result<String> {
    let mut text = "\
        | core | draws spheres, planes | draws all | decodes spheres, planes | decodes all | firmware | RAM |\n\
        |---|--:|--:|--:|--:|--:|--:|\n"
        .to_owned();
    for Flash {
        core,
        full,
        minimal,
    } in flash
    {
        let row = rows.iter().find(|row| row.core == *core);
        let row = row.with_context(|| format!("{core} is not counted"))?;
        let cells = [minimal[0], full[0], minimal[1], full[1], row.flash, row.ram];
        let cells = cells.map(thousands).join(" | ");
        writeln!(text, "| {} | {cells} |", core.title())?;
    }
    Ok(text)
}

/// Returns a table with the flash and RAM of each board's firmware.
pub(super) fn boards(boards: &[(&str, Usage)]) -> Result<String> {
    let mut text = "| board | flash | static RAM |\n|---|--:|--:|\n".to_owned();
    for (board, Usage { flash, ram }) in boards {
        let [flash, ram] = [*flash, *ram].map(thousands);
        writeln!(text, "| `{board}` | {flash} | {ram} |")?;
    }
    Ok(text)
}

/// Returns a table with the flash that each choice of a program costs.
pub(super) fn choices(rows: &[choices::Row]) -> Result<String> {
    let mut text = "| choice | Cortex-M0+ | Cortex-M3 |\n|---|--:|--:|\n".to_owned();
    for choices::Row {
        title, flash, base, ..
    } in rows
    {
        let cell = |index: usize| {
            let Some(base) = base else {
                return thousands(flash[index]);
            };
            let sign = if flash[index] < base[index] { "-" } else { "+" };
            format!("{sign}{}", thousands(flash[index].abs_diff(base[index])))
        };
        let [m0, m3] = [0, 1].map(cell);
        writeln!(text, "| {title} | {m0} | {m3} |")?;
    }
    Ok(text)
}

/// Formats 12345678 as "12.3 M".
fn millions(count: u64) -> String {
    let millions = count as f64 / 1e6;
    if millions < 100.0 {
        format!("{millions:.1} M")
    } else {
        format!("{} M", thousands(millions.round() as u64))
    }
}

/// Formats 12345678 as "12,345,678".
fn thousands(count: u64) -> String {
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
    fn groups_and_rounds_numbers() {
        let grouped = [7, 1234, 1_234_567].map(thousands);
        assert_eq!(grouped, ["7", "1,234", "1,234,567"]);
        let rounded = [61_100_000, 1_177_000_000].map(millions);
        assert_eq!(rounded, ["61.1 M", "1,177 M"]);
    }

    #[test]
    fn the_page_has_all_sections() -> Result<()> {
        let page = fs::read_to_string(root().join(FILE))?;
        for name in ["frames", "flash", "boards"] {
            assert!(replaced(&page, name, "").is_some(), "{name}");
        }
        let page = fs::read_to_string(root().join(FLASH))?;
        assert!(replaced(&page, "choices", "").is_some());
        Ok(())
    }
}
