//! What nothing may be left out of: the firmware that proves that nothing
//! panics calls every public function of the library.

use std::collections::BTreeSet;

use super::Complaint;
use super::tokens::Source;

/// Those for the compiler's use: run time has no literals to read.
const CONSTANT: [&str; 1] = ["lit"];

/// Complains about each public function whose name the callers never say.
pub(super) fn check(library: &[Source], callers: &[Source]) -> Vec<Complaint> {
    let tokens = callers.iter().flat_map(|source| &source.tokens);
    let called: BTreeSet<&str> = tokens.map(|token| token.text.as_str()).collect();
    let of = |source| complaints(source, &called);
    library.iter().flat_map(of).collect()
}

fn complaints<'s>(
    source: &'s Source,
    called: &'s BTreeSet<&str>,
) -> impl Iterator<Item = Complaint> + 's {
    let public = (0..source.tokens.len()).filter_map(|index| public_function(source, index));
    let missing = public.filter(|index| {
        let name = source.text(*index);
        !called.contains(name) && !CONSTANT.contains(&name)
    });
    missing.map(|index| {
        let what = format!("{}: boards/nopanic does not call it", source.text(index));
        source.complain(index, &what)
    })
}

/// Where the name is of a public function whose declaration begins here.
fn public_function(source: &Source, index: usize) -> Option<usize> {
    let is_const = source.text(index + 1) == "const";
    let function = index + 1 + usize::from(is_const);
    (source.text(index) == "pub" && source.text(function) == "fn").then_some(function + 1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use anyhow::Result;
    use std::path::Path;

    #[test]
    fn what_is_never_called_is_caught() -> Result<()> {
        let library = "pub fn f() {} pub const fn g() {} pub(crate) fn h() {} fn i() {}";
        let library = [Source::parse(Path::new("src/a.rs"), library)?];
        let caller = |text| Ok::<_, anyhow::Error>([Source::parse(Path::new("main.rs"), text)?]);
        assert_eq!(check(&library, &caller("f(); x.g();")?), [""; 0]);
        let complaints = check(&library, &caller("f();")?);
        assert_eq!(
            complaints,
            ["src/a.rs:1: g: boards/nopanic does not call it"]
        );
        Ok(())
    }
}
