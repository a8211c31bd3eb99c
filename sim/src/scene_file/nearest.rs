/// The candidate that a misspelt name most likely means, if any is near.
pub fn nearest<'c>(name: &str, candidates: impl IntoIterator<Item = &'c str>) -> Option<&'c str> {
    let name = name.to_lowercase();
    candidates
        .into_iter()
        .filter_map(|candidate| Some((distance(&name, &candidate.to_lowercase())?, candidate)))
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, candidate)| candidate)
}

/// How many letters differ, if the rest is enough to recognize the name by:
/// three fifths of it, or its beginning.
fn distance(name: &str, candidate: &str) -> Option<usize> {
    let edits = strsim::osa_distance(name, candidate);
    let length = name.chars().count().max(candidate.chars().count());
    let begins = name.len() > 1 && candidate.starts_with(name);
    (5 * edits <= 2 * length + 1 || begins).then_some(edits)
}

/// Advice on a name that is not among the candidates.
pub(super) fn advice<'c>(
    name: &str,
    candidates: impl IntoIterator<Item = &'c str> + Clone,
    these_are: &str,
) -> String {
    match nearest(name, candidates.clone()) {
        Some(candidate) => format!("did you mean `{candidate}`?"),
        None => format!("{these_are} {}", list(candidates)),
    }
}

/// The names, each quoted.
pub(super) fn list<'c>(names: impl IntoIterator<Item = &'c str>) -> String {
    let quoted: Vec<_> = names.into_iter().map(|name| format!("`{name}`")).collect();
    quoted.join(", ")
}
