use std::path::Path;

use crate::outcome::Outcome;

/// A type of output file and the file names that belong to it.
pub(crate) struct FileType {
    title: &'static str,
    /// Extensions in lowercase.
    extensions: &'static [&'static str],
    help: &'static str,
}

impl FileType {
    pub(crate) const PNG: Self = Self {
        title: "a PNG",
        extensions: &["png"],
        help: "write FILE.png",
    };
    pub(crate) const GIF: Self = Self {
        title: "a GIF",
        extensions: &["gif"],
        help: "write FILE.gif",
    };
    pub(crate) const APNG: Self = Self {
        title: "an APNG",
        extensions: &["apng", "png"],
        help: "write FILE.apng",
    };
    pub(crate) const COMPILED_SCENE: Self = Self {
        title: "a compiled scene",
        extensions: &["scene", "bin"],
        help: "write FILE.scene or FILE.bin",
    };
    pub(crate) const HTML: Self = Self {
        title: "an HTML page",
        extensions: &["html"],
        help: "write FILE.html",
    };

    /// Returns an error unless the name of a file has an extension of this type.
    pub(super) fn check(&self, path: &Path) -> Outcome {
        match extension(path) {
            Some(extension) if self.extensions.contains(&extension.as_str()) => Ok(()),
            _ => {
                let Self { title, help, .. } = self;
                let path = path.display();
                Err(format!("{path}: not the name of {title}\n  help: {help}").into())
            }
        }
    }
}

/// Returns the extension of a file name in lowercase, or `None` if the name has no extension.
pub(crate) fn extension(path: &Path) -> Option<String> {
    let extension = path.extension()?.to_str()?;
    Some(extension.to_ascii_lowercase())
}
