//! Suggests a known name for a misspelled name.

use crate::text::excerpt;

/// Returns the candidate closest to a misspelled name, or `None` if no candidate is close enough.
///
/// A candidate is close enough if at most two fifths of its letters differ from the misspelled
/// name, or if the candidate begins with the misspelled name. Upper and lower case count as equal.
/// A name of more than 64 bytes is not compared, because the time grows with the product of the
/// lengths.
pub fn nearest<'c>(name: &str, candidates: impl IntoIterator<Item = &'c str>) -> Option<&'c str> {
    const LENGTH: usize = 64;
    let is_short = |name: &str| name.len() <= LENGTH;
    if !is_short(name) {
        return None;
    }
    let name = name.to_lowercase();
    candidates
        .into_iter()
        .filter(|candidate| is_short(candidate))
        .filter_map(|candidate| Some((distance(&name, &candidate.to_lowercase())?, candidate)))
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, candidate)| candidate)
}

/// Returns the edit distance of two names (optimal string alignment). Returns `None` if the names
/// are too different for one to be a misspelling of the other.
fn distance(name: &str, candidate: &str) -> Option<usize> {
    let edits = strsim::osa_distance(name, candidate);
    let length = name.chars().count().max(candidate.chars().count());
    let is_prefix = name.len() > 1 && candidate.starts_with(name);
    (5 * edits <= 2 * length + 1 || is_prefix).then_some(edits)
}

/// Returns the help text for an unknown name. The text suggests the nearest candidate. If no
/// candidate is near, the text is `candidates_are`, followed by all candidates.
pub(super) fn suggestion<'c>(
    name: &str,
    candidates: impl IntoIterator<Item = &'c str> + Clone,
    candidates_are: &str,
) -> String {
    match nearest(name, candidates.clone()) {
        Some(candidate) => format!("did you mean `{}`?", excerpt(candidate)),
        None => format!("{candidates_are} {}", quoted_list(candidates)),
    }
}

/// Formats names as a list, each in backquotes. The list has at most 20 names.
pub(super) fn quoted_list<'c>(names: impl IntoIterator<Item = &'c str>) -> String {
    const COUNT: usize = 20;
    let mut names = names.into_iter().map(|name| format!("`{}`", excerpt(name)));
    let mut quoted: Vec<_> = names.by_ref().take(COUNT).collect();
    quoted.extend(names.next().map(|_| "…".to_owned()));
    quoted.join(", ")
}
