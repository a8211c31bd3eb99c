//! Checks that the firmware `tests/rigs/nopanic` mentions every public function of the library.

use std::collections::BTreeSet;

use super::source::Source;

/// Functions that the firmware need not mention, because they run at compile time.
const COMPILE_TIME: [&str; 2] = ["lit", "parse_literal"];

/// Returns a violation for each public function whose name the firmware does not mention.
pub(super) fn check(sources: &[Source]) -> Vec<String> {
    let inside = |folder: &'static str| {
        let sources = sources.iter();
        sources.filter(move |source| source.path.starts_with(folder))
    };
    let callers = inside("tests/rigs/nopanic/src").flat_map(|source| &source.tokens);
    let called: BTreeSet<_> = callers.map(|token| token.text.as_str()).collect();
    let mut violations = Vec::new();
    for source in inside("src") {
        for index in 0..source.tokens.len() {
            let is_const = source.text(index + 1) == "const";
            let function = index + 1 + usize::from(is_const);
            let name = source.text(function + 1);
            if source.text(index) == "pub"
                && source.text(function) == "fn"
                && !called.contains(name)
                && !COMPILE_TIME.contains(&name)
            {
                let text = format!("tests/rigs/nopanic does not call `{name}`");
                violations.push(source.at(source.tokens[index].line, &text));
            }
        }
    }
    violations
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tidy::source::parse_all;

    #[test]
    fn finds_functions_that_are_not_called() -> anyhow::Result<()> {
        let library = "pub fn f() {} pub const fn g() {} pub(crate) fn h() {} fn i() {}";
        let caller = ("tests/rigs/nopanic/src/main.rs", "f();");
        let expected = "src/a.rs:1: tests/rigs/nopanic does not call `g`";
        assert_eq!(
            check(&parse_all(&[("src/a.rs", library), caller])?),
            [expected]
        );
        Ok(())
    }
}
