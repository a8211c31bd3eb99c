use whitted_sim::scene_file::{self, Buffer};

use super::picture::draw_as_compiled;

/// Any text is a scene that can be drawn and compiled, or an error that can be told.
pub fn scene_text(input: &[u8]) {
    let Ok(text) = core::str::from_utf8(input) else {
        return;
    };
    match scene_file::parse("scene.toml", text) {
        Ok(file) => match file.prepare(&mut Box::new(Buffer::new())) {
            Ok(scene) => draw_as_compiled(&scene),
            Err(error) => _ = error.to_string(),
        },
        Err(error) => _ = error.to_string(),
    }
}
