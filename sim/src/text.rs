//! Text of files, file names and boards in messages.
//!
//! Such text may have any length and any characters. A message shows its start, without characters
//! that control a terminal.

/// Number of characters that [`excerpt`] keeps.
const LENGTH: usize = 60;

/// Returns the first 60 characters of a text, escaped like [`escaped`]. If the text is longer, `…`
/// follows.
pub fn excerpt(text: &str) -> String {
    match text.char_indices().nth(LENGTH) {
        Some((end, _)) => format!("{}…", escaped(text.get(..end).unwrap_or_default())),
        None => escaped(text),
    }
}

/// Replaces each character that can control a terminal by its escape sequence, such as `\u{1b}` or
/// `\n`.
pub fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for character in text.chars() {
        if is_control(character) {
            escaped.extend(character.escape_default());
        } else {
            escaped.push(character);
        }
    }
    escaped
}

/// Escapes each line of a text like [`escaped`], and keeps the line ends.
pub fn escaped_lines(text: &str) -> String {
    let lines: Vec<_> = text.split('\n').map(escaped).collect();
    lines.join("\n")
}

/// Returns true for control characters, line separators, and invisible characters that change the
/// direction or the order of text.
fn is_control(character: char) -> bool {
    character.is_control()
        || matches!(
            character,
            '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{feff}'
        )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn escapes_what_controls_a_terminal() {
        assert_eq!(
            escaped("a\u{1b}[2J\u{7}\n\u{9b}"),
            r"a\u{1b}[2J\u{7}\n\u{9b}"
        );
        assert_eq!(escaped_lines("a\r\n\u{7}\n"), "a\\r\n\\u{7}\n");
        assert_eq!(escaped("\u{202e}lmot.\u{2028}"), r"\u{202e}lmot.\u{2028}");
        assert_eq!(escaped(r#"Höhe "é" \n"#), r#"Höhe "é" \n"#);
    }

    #[test]
    fn cuts_long_text() {
        assert_eq!(excerpt("ball"), "ball");
        assert_eq!(excerpt(&"ö".repeat(60)), "ö".repeat(60));
        assert_eq!(excerpt(&"ö".repeat(61)), "ö".repeat(60) + "…");
        assert_eq!(excerpt(&"\n".repeat(61)), r"\n".repeat(60) + "…");
    }
}
