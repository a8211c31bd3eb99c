/// Returns the comment at the top of a scene file as one line: the text of its first lines that
/// begin with `#`. Returns `None` if the file does not begin with a comment.
pub(super) fn comment(text: &str) -> Option<String> {
    let lines = text.lines().map_while(|line| line.strip_prefix('#'));
    let words: Vec<_> = lines.flat_map(str::split_whitespace).collect();
    (!words.is_empty()).then(|| words.join(" "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn joins_the_first_lines() {
        let text = "# Two balls,\n#  one of glass.\n\n# Colors\nmax_depth = 1\n";
        assert_eq!(comment(text).as_deref(), Some("Two balls, one of glass."));
        assert_eq!(comment("max_depth = 1 # deep\n"), None);
        assert_eq!(comment("#\n"), None);
    }
}
