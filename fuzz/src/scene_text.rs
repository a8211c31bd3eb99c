use whitted_sim::scene_file::{self, Buffer};

use super::picture::draw_as_compiled;

/// Checks that any text is a scene that can be drawn and compiled, or gives an error.
///
/// Returns true if the text is a valid scene.
pub fn scene_text(input: &[u8]) -> bool {
    let Ok(text) = core::str::from_utf8(input) else {
        return false;
    };
    match scene_file::parse("scene.toml", text) {
        Ok(file) => match file.prepare(&mut Box::new(Buffer::new())) {
            Ok(scene) => {
                draw_as_compiled(&scene);
                true
            }
            Err(error) => error.to_string().is_empty(),
        },
        Err(error) => error.to_string().is_empty(),
    }
}
