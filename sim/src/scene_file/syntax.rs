//! Syntax of TOML, and its errors.

use toml::Spanned;
use toml::de::{DeTable, Error};

use super::error::LoadError;
use super::source::Source;
use crate::text::excerpt;

const TOML: &str = "a scene is written in TOML: `key = value` lines under [table] headings";

/// Largest number of tables and arrays inside each other that the TOML parser accepts.
const NESTING: usize = 80;

/// Parses the text of a scene file as TOML.
pub(super) fn parse<'a>(source: &Source<'a>) -> Result<Spanned<DeTable<'a>>, LoadError> {
    DeTable::parse(source.text).map_err(|error| syntax_error(source, &error))
}

/// Converts an error of the TOML parser to an error that shows the text at its place.
fn syntax_error(source: &Source<'_>, error: &Error) -> LoadError {
    let Some(place) = error.span() else {
        return dotted_key(source, error);
    };
    let found = source.text.get(place.clone()).unwrap_or_default();
    if error.message() == "duplicate key" {
        let help = match found {
            "objects" | "lights" => format!("write `[[{found}]]` for each of them"),
            _ => "remove or rename one of the two".to_owned(),
        };
        return source.error(&place, found, "is defined twice").help(help);
    }
    if error.message().starts_with("cannot recurse") {
        let reason = format!("more than {NESTING} arrays or tables are inside each other");
        return source.error(&place, "", reason).help("remove brackets");
    }
    let (before, rest) = source
        .text
        .split_at_checked(place.start)
        .unwrap_or_default();
    let line = before.rsplit('\n').next().unwrap_or_default();
    let rest = rest.lines().next().unwrap_or_default();
    let found = match rest {
        "" => "the end of the line".to_owned(),
        rest => format!("`{}`", excerpt(rest)),
    };
    let reason = format!("{}, found {found}", error.message());
    source.error(&place, "", reason).help(help(line, rest))
}

/// Returns the error for a key of too many parts. The parser does not tell the place of this error.
fn dotted_key(source: &Source<'_>, error: &Error) -> LoadError {
    let is_long = |line: &str| line.split('.').count() >= NESTING;
    let line = source.text.lines().position(is_long);
    LoadError {
        file: source.name.to_owned(),
        line: line.map(|index| 1 + index),
        key: None,
        reason: match line {
            Some(_) => format!("a key has {NESTING} or more parts"),
            None => error.message().to_owned(),
        },
        help: Some("write a key of fewer parts".to_owned()),
    }
}

/// Returns the advice for common mistakes. `before` and `rest` are the two parts of the line, before
/// and after the place of the error.
fn help(before: &str, rest: &str) -> String {
    let after_digit = before.ends_with(|last: char| last.is_ascii_digit());
    let begins_with_digit = |text: &str| text.starts_with(|first: char| first.is_ascii_digit());
    let has_comma = match rest.strip_prefix(',') {
        Some(decimals) => after_digit && begins_with_digit(decimals),
        None => begins_with_digit(rest) && follows_decimal_comma(before),
    };
    let line = before.trim_start();
    let help = if has_comma {
        "write numbers with a decimal point, for example 0.05"
    } else if [line, rest]
        .iter()
        .any(|text| text.starts_with("//") || text.starts_with("/*"))
    {
        "begin a comment with `#`"
    } else if rest.starts_with(':') || before.trim_end().ends_with(':') {
        "write `=` between a key and its value"
    } else if rest.starts_with('.') || before.ends_with('.') {
        "write a digit before and after the decimal point, for example 0.5"
    } else if rest.starts_with("True") || rest.starts_with("False") {
        "write `true` or `false`"
    } else {
        TOML
    };
    help.to_owned()
}

/// Returns true if a text ends in a digit and a comma without a space, such as `[0,`.
fn follows_decimal_comma(before: &str) -> bool {
    let before = before.strip_suffix(',');
    before.is_some_and(|before| before.ends_with(|last: char| last.is_ascii_digit()))
}
