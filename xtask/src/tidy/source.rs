use std::path::{Path, PathBuf};
use std::str::FromStr;

use anyhow::{Result, anyhow};
use proc_macro2::{Delimiter, Spacing, TokenStream, TokenTree};

/// The tokens of a Rust file in a flat list. Comments, attributes and tests are left out.
pub(super) struct Source {
    /// Path relative to the root of the project.
    pub(super) path: PathBuf,
    pub(super) tokens: Vec<Token>,
}

/// A token: an identifier, a literal, `::`, or a single punctuation character or bracket.
pub(super) struct Token {
    pub(super) text: String,
    pub(super) line: usize,
}

impl Source {
    pub(super) fn parse(path: &Path, text: &str) -> Result<Self> {
        let stream = TokenStream::from_str(text).map_err(|error| {
            let line = error.span().start().line;
            anyhow!("{}:{line}: {error}", path.display())
        })?;
        let mut tokens = Vec::new();
        flatten(stream, &mut tokens);
        Ok(Self {
            path: path.to_owned(),
            tokens,
        })
    }

    /// Returns the text of the token at an index, or an empty text if there is no such token.
    pub(super) fn text(&self, index: usize) -> &str {
        self.tokens.get(index).map_or("", |token| &token.text)
    }

    /// Formats a violation of a rule with the file and the line.
    pub(super) fn at(&self, line: usize, violation: &str) -> String {
        format!("{}:{line}: {violation}", self.path.display())
    }
}

fn flatten(stream: TokenStream, tokens: &mut Vec<Token>) {
    let mut trees = stream.into_iter().peekable();
    while let Some(tree) = trees.next() {
        let line = tree.span().start().line;
        match tree {
            TokenTree::Punct(mark) if mark.as_char() == '#' => {
                let is_inner = trees.next_if(|tree| tree.to_string() == "!").is_some();
                if !trees.next().is_some_and(|attribute| is_test(&attribute)) {
                    continue;
                }
                if is_inner {
                    return;
                }
                // Skips the rest of the test item. The item ends with a body in braces or with a
                // semicolon.
                trees.by_ref().find(|tree| match tree {
                    TokenTree::Group(group) => group.delimiter() == Delimiter::Brace,
                    tree => tree.to_string() == ";",
                });
            }
            TokenTree::Punct(mark) if mark.as_char() == ':' && mark.spacing() == Spacing::Joint => {
                trees.next_if(|tree| tree.to_string() == ":");
                push("::", line, tokens);
            }
            TokenTree::Group(group) => {
                let [open, close] = match group.delimiter() {
                    Delimiter::Parenthesis => ["(", ")"],
                    Delimiter::Brace => ["{", "}"],
                    Delimiter::Bracket => ["[", "]"],
                    Delimiter::None => ["", ""],
                };
                push(open, line, tokens);
                flatten(group.stream(), tokens);
                push(close, group.span_close().start().line, tokens);
            }
            other => push(&other.to_string(), line, tokens),
        }
    }
}

fn push(text: &str, line: usize, tokens: &mut Vec<Token>) {
    let text = text.to_owned();
    tokens.push(Token { text, line });
}

/// Returns true for the brackets of `#[test]` and `#[cfg(test)]`.
fn is_test(attribute: &TokenTree) -> bool {
    let text: String = attribute.to_string().split_whitespace().collect();
    matches!(text.as_str(), "[test]" | "[cfg(test)]")
}

#[cfg(test)]
pub(super) fn parse_all(files: &[(&str, &str)]) -> Result<Vec<Source>> {
    let files = files.iter();
    let parse = |(path, text): &(&str, &str)| Source::parse(path.as_ref(), text);
    files.map(parse).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn omits_comments_attributes_and_tests() -> Result<()> {
        let text = "
            //! Text.
            #![no_std]
            #[inline] fn f() {} // text
            #[cfg(test)] mod tests { fn g() {} }
            #[cfg(test)] use std::vec;
            const C: u8 = a::b;
        ";
        let source = Source::parse(Path::new("a.rs"), text)?;
        let texts: Vec<_> = source.tokens.iter().map(|token| &*token.text).collect();
        assert_eq!(texts.join(" "), "fn f ( ) { } const C : u8 = a :: b ;");
        let tests = Source::parse(Path::new("a.rs"), "#![cfg(test)] fn f() {}")?;
        assert!(tests.tokens.is_empty());
        Ok(())
    }
}
