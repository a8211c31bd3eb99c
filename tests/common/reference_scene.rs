//! Finds the scene that a reference image shows.

use std::fs;

/// Returns the text of the scene file that the reference image `image` shows. `tests` is the path
/// of the project's folder of tests.
///
/// The image `NAME` shows the scene `NAME`. The image `NAME_depth_N` shows the scene `NAME` with a
/// `max_depth` of `N`.
pub(crate) fn text(tests: &str, image: &str) -> String {
    let (name, depth) = image.split_once("_depth_").unwrap_or((image, "6"));
    let path = format!("{tests}/scenes/{name}.toml");
    let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"));
    text.replace("max_depth = 6", &format!("max_depth = {depth}"))
}
