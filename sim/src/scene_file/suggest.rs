//! Suggests a known name for a misspelled name.

/// Returns the candidate closest to a misspelled name, if one is close enough.
///
/// A candidate is close enough if at most two fifths of its letters differ from the misspelled
/// name, or if it begins with that name. Case is ignored.
pub fn nearest<'c>(name: &str, candidates: impl IntoIterator<Item = &'c str>) -> Option<&'c str> {
    let name = name.to_lowercase();
    candidates
        .into_iter()
        .filter_map(|candidate| Some((distance(&name, &candidate.to_lowercase())?, candidate)))
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, candidate)| candidate)
}

/// Returns the edit distance (optimal string alignment) of two names, or `None` if they are too
/// different to be the same word.
fn distance(name: &str, candidate: &str) -> Option<usize> {
    let edits = strsim::osa_distance(name, candidate);
    let length = name.chars().count().max(candidate.chars().count());
    let is_prefix = name.len() > 1 && candidate.starts_with(name);
    (5 * edits <= 2 * length + 1 || is_prefix).then_some(edits)
}

/// Returns the help text for an unknown name. The text suggests the nearest candidate. If no
/// candidate is near, it is `candidates_are` followed by all candidates.
pub(super) fn suggestion<'c>(
    name: &str,
    candidates: impl IntoIterator<Item = &'c str> + Clone,
    candidates_are: &str,
) -> String {
    match nearest(name, candidates.clone()) {
        Some(candidate) => format!("did you mean `{candidate}`?"),
        None => format!("{candidates_are} {}", quoted_list(candidates)),
    }
}

/// Formats names as a list, each in backquotes.
pub(super) fn quoted_list<'c>(names: impl IntoIterator<Item = &'c str>) -> String {
    let quoted: Vec<_> = names.into_iter().map(|name| format!("`{name}`")).collect();
    quoted.join(", ")
}
