//! Rust as a flat list of tokens, without comments, attributes and tests.

use std::path::{Path, PathBuf};
use std::str::FromStr;

use anyhow::{Result, anyhow};
use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};

/// A source file.
pub(super) struct Source {
    /// Relative to the root of the project.
    pub(super) path: PathBuf,
    pub(super) tokens: Vec<Token>,
}

/// An identifier, a literal, or a single character of punctuation; brackets
/// are punctuation too.
pub(super) struct Token {
    pub(super) text: String,
    pub(super) line: usize,
}

impl Source {
    /// Takes the text of a file apart.
    pub(super) fn parse(path: &Path, text: &str) -> Result<Self> {
        let stream = TokenStream::from_str(text).map_err(|error| {
            anyhow!("{}:{}: {error}", path.display(), error.span().start().line)
        })?;
        let mut tokens = Vec::new();
        flatten(stream, &mut tokens);
        Ok(Self {
            path: path.to_owned(),
            tokens,
        })
    }

    /// The text of a token; nothing before the first and after the last.
    pub(super) fn text(&self, index: usize) -> &str {
        self.tokens.get(index).map_or("", |token| &token.text)
    }

    /// The text of the token that is so many before this one.
    pub(super) fn before(&self, index: usize, distance: usize) -> &str {
        index
            .checked_sub(distance)
            .map_or("", |index| self.text(index))
    }

    /// A complaint about a token.
    pub(super) fn complain(&self, index: usize, what: &str) -> super::Complaint {
        let line = self.tokens.get(index).map_or(0, |token| token.line);
        format!("{}:{line}: {what}", self.path.display())
    }
}

fn flatten(stream: TokenStream, tokens: &mut Vec<Token>) {
    let mut trees = stream.into_iter().peekable();
    while let Some(tree) = trees.next() {
        match tree {
            TokenTree::Punct(mark) if mark.as_char() == '#' => {
                // The ! of an attribute of the whole file.
                let whole = trees.next_if(
                    |next| matches!(next, TokenTree::Punct(mark) if mark.as_char() == '!'),
                );
                let attribute = trees.next();
                if attribute.is_some_and(|tree| is_test(&tree)) {
                    if whole.is_some() {
                        return;
                    }
                    // An item ends with its body, or with a semicolon.
                    trees.by_ref().find(|tree| match tree {
                        TokenTree::Group(group) => group.delimiter() == Delimiter::Brace,
                        TokenTree::Punct(mark) => mark.as_char() == ';',
                        _ => false,
                    });
                }
            }
            TokenTree::Group(group) => {
                let [open, close] = brackets(&group);
                push(open, group.span_open().start().line, tokens);
                flatten(group.stream(), tokens);
                push(close, group.span_close().start().line, tokens);
            }
            other => push(&other.to_string(), other.span().start().line, tokens),
        }
    }
}

fn push(text: &str, line: usize, tokens: &mut Vec<Token>) {
    let text = text.to_owned();
    tokens.push(Token { text, line });
}

/// Whether the brackets of an attribute hold `cfg(test)` or `test`.
fn is_test(attribute: &TokenTree) -> bool {
    let TokenTree::Group(group) = attribute else {
        return false;
    };
    let text: String = group.stream().to_string().split_whitespace().collect();
    matches!(text.as_str(), "test" | "cfg(test)")
}

fn brackets(group: &Group) -> [&'static str; 2] {
    match group.delimiter() {
        Delimiter::Parenthesis => ["(", ")"],
        Delimiter::Brace => ["{", "}"],
        Delimiter::Bracket => ["[", "]"],
        Delimiter::None => ["", ""],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_of_tests_is_left_out() -> Result<()> {
        let text = "#![cfg(test)] fn f() {}";
        assert!(
            Source::parse(Path::new("src/a.rs"), text)?
                .tokens
                .is_empty()
        );
        Ok(())
    }

    #[test]
    fn comments_attributes_and_tests_are_left_out() -> Result<()> {
        let text = "
            //! Prose.
            #![no_std]
            /// More prose.
            #[inline] fn f() {} // why
            #[cfg(test)] mod tests { fn g() {} }
            #[cfg(test)] use std::vec;
            const C: u8 = 1;
        ";
        let source = Source::parse(Path::new("src/a.rs"), text)?;
        let texts: Vec<&str> = source
            .tokens
            .iter()
            .map(|token| token.text.as_str())
            .collect();
        assert_eq!(texts.concat(), "fnf(){}constC:u8=1;");
        assert_eq!(source.complain(0, "here"), "src/a.rs:5: here");
        Ok(())
    }
}
