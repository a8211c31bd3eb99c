use std::iter::Peekable;
use std::path::{Path, PathBuf};

use anyhow::{Result, anyhow};
use proc_macro2::{Delimiter, TokenStream, TokenTree, token_stream};

/// A source file of the library, as tokens.
pub(super) struct Source {
    pub(super) path: PathBuf,
    /// The module of `src` that it belongs to.
    pub(super) module: String,
    /// Identifiers, keywords and literals.
    pub(super) words: Vec<Word>,
    /// What is named right after `crate::`, and on which line.
    pub(super) uses: Vec<(String, usize)>,
}

pub(super) struct Word {
    pub(super) text: String,
    pub(super) line: usize,
    pub(super) is_float: bool,
}

type Tokens = Peekable<token_stream::IntoIter>;

impl Source {
    pub(super) fn read(path: &Path, text: &str) -> Result<Self> {
        let tokens: TokenStream = text.parse().map_err(|error| anyhow!("{error}"))?;
        // The first folder or file below `src`.
        let mut parts = path
            .components()
            .map(|part| part.as_os_str())
            .skip_while(|part| *part != "src");
        let module = Path::new(parts.nth(1).unwrap_or_default()).with_extension("");
        let mut source = Self {
            path: path.to_owned(),
            module: module.display().to_string(),
            words: Vec::new(),
            uses: Vec::new(),
        };
        source.visit(tokens);
        Ok(source)
    }

    fn visit(&mut self, tokens: TokenStream) {
        let mut tokens = tokens.into_iter().peekable();
        while let Some(token) = tokens.next() {
            match token {
                TokenTree::Punct(punct) if punct.as_char() == '#' => {
                    if is_cfg_test(tokens.peek()) {
                        skip_item(&mut tokens);
                    }
                }
                TokenTree::Ident(ident) if ident == "crate" => self.visit_path(&mut tokens),
                TokenTree::Group(group) => self.visit(group.stream()),
                TokenTree::Ident(_) | TokenTree::Literal(_) => {
                    let (text, line) = (token.to_string(), token.span().start().line);
                    let is_float = matches!(token, TokenTree::Literal(_)) && is_float(&text);
                    self.words.push(Word {
                        text,
                        line,
                        is_float,
                    });
                }
                TokenTree::Punct(_) => {}
            }
        }
    }

    /// What follows `crate`: `::name`, or `::{name, other::name}`.
    fn visit_path(&mut self, tokens: &mut Tokens) {
        while tokens.next_if(|token| token.to_string() == ":").is_some() {}
        match tokens.peek() {
            Some(TokenTree::Ident(ident)) => {
                let line = ident.span().start().line;
                self.uses.push((ident.to_string(), line));
            }
            Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Brace => {
                let mut is_first = true;
                for token in group.stream() {
                    match token {
                        TokenTree::Ident(ident) if is_first => {
                            self.uses
                                .push((ident.to_string(), ident.span().start().line));
                            is_first = false;
                        }
                        TokenTree::Punct(punct) if punct.as_char() == ',' => is_first = true,
                        _ => {}
                    }
                }
            }
            // `pub(crate)`
            _ => {}
        }
    }
}

fn is_cfg_test(attribute: Option<&TokenTree>) -> bool {
    matches!(attribute, Some(TokenTree::Group(group)) if group.stream().to_string().replace(' ', "") == "cfg(test)")
}

/// Passes an attribute and the item behind it, to its body or its semicolon.
fn skip_item(tokens: &mut Tokens) {
    for token in tokens {
        match token {
            TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => return,
            TokenTree::Punct(punct) if punct.as_char() == ';' => return,
            _ => {}
        }
    }
}

fn is_float(literal: &str) -> bool {
    literal.starts_with(|c: char| c.is_ascii_digit())
        && !literal.starts_with("0x")
        && (literal.contains(['.', 'e']) || literal.ends_with("f32") || literal.ends_with("f64"))
}
