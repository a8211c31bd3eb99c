use std::fmt::Write;
use std::path::{Path, PathBuf};

use embedded_graphics::geometry::Size;

use crate::number::grouped;

/// A picture on the HTML page of the gallery.
pub(super) struct Entry {
    pub(super) title: String,
    /// Comment of the scene file. It is empty if there is none.
    pub(super) comment: String,
    /// File name of the picture, relative to the page.
    pub(super) file: String,
    /// Path of the scene file, or the name of a scene in scenes/.
    pub(super) scene: PathBuf,
    pub(super) is_animated: bool,
    /// Number of rays of all kinds.
    pub(super) rays: u64,
}

const HEAD: &str = r#"<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Gallery</title>
<style>
  :root { color-scheme: light dark; }
  body { margin: 1.5rem; font: 1rem/1.4 system-ui, sans-serif; }
  main { display: grid; gap: 1.5rem; grid-template-columns: repeat(auto-fill, minmax(min(20rem, 100%), 1fr)); }
  figure { margin: 0; }
  img { display: block; width: 100%; height: auto; }
  figcaption { margin-top: 0.5rem; }
  p { margin: 0.25rem 0; }
  small { display: block; opacity: 0.75; }
</style>
<main>
"#;

/// Returns the HTML page of the gallery. The page needs no files except the pictures.
pub(super) fn page(entries: &[Entry], size: Size) -> String {
    let mut page = HEAD.to_owned();
    for entry in entries {
        // Writing to a string does not fail.
        let _ = entry.write(size, &mut page);
    }
    page.push_str("</main>\n</html>\n");
    page
}

impl Entry {
    /// Writes the picture and its caption: title, comment, figure, size, file and command.
    fn write(&self, Size { width, height }: Size, page: &mut String) -> std::fmt::Result {
        let (title, link) = (escape_html(&self.title), encode_url(&self.file));
        let (figure, comment) = split_figure(&self.comment);
        let [figure, comment] =
            [figure.to_owned(), capitalized(comment)].map(|it| escape_html(&it));
        let scene = file_in_project(&self.scene);
        let [scene, command] = [&scene, &self.command()].map(|text| escape_html(text));
        let rays = grouped(self.rays);
        write!(
            page,
            r#"<figure>
  <a href="{link}"><img src="{link}" width="{width}" height="{height}" alt="{title}"></a>
  <figcaption><strong>{title}</strong>
    <p>{comment}</p>
    <small>{figure}</small>
    <small>{width}x{height}, {rays} rays, scene <code>{scene}</code></small>
    <small><code>{command}</code></small></figcaption>
</figure>
"#
        )
    }

    /// Returns the command that renders the scene.
    fn command(&self) -> String {
        let stem = self.scene.file_stem().unwrap_or_default();
        let name = stem.to_string_lossy();
        let scene = match file_in_project(&self.scene).strip_prefix("scenes/") {
            Some(_) => name.clone(),
            None => self.scene.to_string_lossy(),
        };
        match self.is_animated {
            true => format!("cargo sim animate {scene} -o {name}.gif"),
            false => format!("cargo sim render {scene}"),
        }
    }
}

/// Splits a comment such as "Figure 7 of a book: a ball." into the figure and the rest. The figure
/// is empty if the comment does not begin with one.
fn split_figure(comment: &str) -> (&str, &str) {
    match comment.split_once(": ") {
        Some((figure, rest)) if figure.starts_with("Figure ") => (figure, rest),
        _ => ("", comment),
    }
}

/// Returns a text whose first letter is a capital.
fn capitalized(text: &str) -> String {
    let mut letters = text.chars();
    let first = letters.next().into_iter().flat_map(char::to_uppercase);
    first.chain(letters).collect()
}

/// Returns the path of a file relative to the project's root. A path outside of the project is not
/// changed.
fn file_in_project(path: &Path) -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent();
    let inside = root.and_then(|root| path.strip_prefix(root).ok());
    inside.unwrap_or(path).display().to_string()
}

/// Escapes text for HTML.
fn escape_html(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}

/// Percent-encodes a file name as a relative URL.
fn encode_url(name: &str) -> String {
    name.bytes().fold(String::new(), |mut url, byte| {
        if byte.is_ascii_alphanumeric() || b"-._~".contains(&byte) {
            url.push(byte.into());
        } else {
            let _ = write!(url, "%{byte:02X}");
        }
        url
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn splits_the_figure_from_the_comment() {
        let figure = split_figure("Figure 7 of a book: a ball: red.");
        assert_eq!(figure, ("Figure 7 of a book", "a ball: red."));
        assert_eq!(split_figure("A ball: red."), ("", "A ball: red."));
        assert_eq!(capitalized("élan"), "Élan");
        assert_eq!(capitalized(""), "");
    }

    #[test]
    fn escapes_special_characters_in_names() {
        assert_eq!(escape_html(r#"<"&">"#), "&lt;&quot;&amp;&quot;&gt;");
        assert_eq!(encode_url("a b#ö.png"), "a%20b%23%C3%B6.png");
    }
}
