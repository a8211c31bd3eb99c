//! What the library must not contain: panics, `unsafe`; and where alone it may
//! use floats, and name the crate of the displays.

use std::path::Path;

use super::Complaint;
use super::tokens::Source;

/// Where colors become pixels, and lines meet a DrawTarget.
const DISPLAY_FILES: [&str; 6] = [
    "src/pixel.rs",
    "src/drawing.rs",
    "src/changes.rs",
    "src/renderer.rs",
    "src/renderer/display.rs",
    "src/antialias.rs",
];

/// Where angles become sines and cosines, by micromath.
const FLOAT_FILE: &str = "src/angle.rs";

const PANICKING_METHODS: [&str; 4] = ["unwrap", "expect", "unwrap_err", "expect_err"];
const PANICKING_MACROS: [&str; 4] = ["panic", "todo", "unimplemented", "unreachable"];

/// Complains about each token that must not be there.
pub(super) fn check(source: &Source) -> Vec<Complaint> {
    let complaint = |index| complaint(source, index).map(|what| source.complain(index, what));
    (0..source.tokens.len()).filter_map(complaint).collect()
}

fn complaint(source: &Source, index: usize) -> Option<&'static str> {
    let text = source.text(index);
    let after_dot = source.before(index, 1) == "." && source.before(index, 2) != ".";
    let is_float = text == "f32" || text == "f64" || (is_float(text) && !after_dot);
    if is_float && source.path != Path::new(FLOAT_FILE) {
        return Some("floating point: every target must compute the same");
    }
    if text == "unsafe" {
        return Some("unsafe: the library needs none");
    }
    if PANICKING_METHODS.contains(&text) && after_dot
        || PANICKING_MACROS.contains(&text) && source.text(index + 1) == "!"
    {
        return Some("panics: tracing is total, and what can fail returns an error");
    }
    if text == "embedded_graphics_core"
        && !DISPLAY_FILES
            .iter()
            .any(|file| source.path == Path::new(file))
    {
        return Some("embedded_graphics_core: named only where pixels meet displays");
    }
    None
}

/// Whether a literal is one of floating point. (After a dot it is the index of
/// a tuple in a tuple, `pair.0.1`.)
fn is_float(literal: &str) -> bool {
    let is_number = literal.starts_with(|first: char| first.is_ascii_digit());
    let is_decimal = !["0x", "0b", "0o"]
        .iter()
        .any(|prefix| literal.starts_with(prefix));
    let exponent = literal.find(['e', 'E']).is_some_and(|e| {
        literal[e + 1..].starts_with(|next: char| next.is_ascii_digit() || "+-".contains(next))
    });
    is_number
        && is_decimal
        && (literal.contains('.')
            || exponent
            || literal.ends_with("f32")
            || literal.ends_with("f64"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn complaints(path: &str, text: &str) -> Vec<Complaint> {
        Source::parse(Path::new(path), text)
            .map_or_else(|error| vec![error.to_string()], |source| check(&source))
    }

    #[test]
    fn each_breach_is_caught() {
        for text in [
            "fn f(x: f32) {}",
            "const C: I = I::from_num(0.5);",
            "let x = 1e3;",
            "let x = 1f64;",
            "let x = a..0.5;",
            "unsafe { f() }",
            "let x = y.unwrap();",
            "let x = y.expect(\"there\");",
            "panic!(\"no\")",
            "todo!()",
            "use embedded_graphics_core::prelude::*;",
        ] {
            assert_eq!(complaints("src/shade.rs", text).len(), 1, "{text}");
        }
    }

    #[test]
    fn what_only_looks_like_a_breach_is_not() {
        for text in [
            "// 0.5 of an f32, and unsafe; panic!()",
            "/// `x.unwrap()` is 0.5\nfn f() {}",
            "#![forbid(unsafe_code)]",
            "#[cfg(test)] mod tests { fn f() { g().unwrap(); } }",
            "const C: Real = Real::lit(\"0.5\");",
            "let x = pair.0.1; let y = 0..10; let z = 0x1e5; let w = 1usize;",
            "let x = y.unwrap_or(0);",
            "fn unreachable() {}",
        ] {
            assert_eq!(complaints("src/shade.rs", text), [""; 0], "{text}");
        }
        assert_eq!(complaints("src/angle.rs", "fn f(x: f32) {}"), [""; 0]);
        let display = "use embedded_graphics_core::prelude::*;";
        assert_eq!(complaints("src/pixel.rs", display), [""; 0]);
    }
}
