use std::fmt::Write;

use embedded_graphics::geometry::Size;

use crate::number::grouped;

/// A picture on the HTML page of the gallery.
pub(super) struct Entry {
    pub(super) title: String,
    /// File name, relative to the page.
    pub(super) file: String,
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
  small { display: block; opacity: 0.75; }
</style>
<main>
"#;

/// Returns the HTML page of the gallery. The page needs no files except the pictures.
pub(super) fn page(entries: &[Entry], Size { width, height }: Size) -> String {
    let mut page = HEAD.to_owned();
    for Entry { title, file, rays } in entries {
        let (title, link, file) = (escape_html(title), encode_url(file), escape_html(file));
        let rays = grouped(*rays);
        // Writing to a string does not fail.
        let _ = write!(
            page,
            r#"<figure>
  <a href="{link}"><img src="{link}" width="{width}" height="{height}" alt="{title}"></a>
  <figcaption>{title}
    <small>{width}x{height}, {rays} rays, <a href="{link}">{file}</a></small></figcaption>
</figure>
"#
        );
    }
    page.push_str("</main>\n</html>\n");
    page
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
    fn escapes_special_characters_in_names() {
        assert_eq!(escape_html(r#"<"&">"#), "&lt;&quot;&amp;&quot;&gt;");
        assert_eq!(encode_url("a b#ö.png"), "a%20b%23%C3%B6.png");
    }
}
