//! Rendering a scene file by the library, as the tests compare it.

use embedded_graphics::geometry::Size;
use whitted::Real;
use whitted_sim::{render, scene_file};

/// Linear colors of 0 to 1, row by row, with no branch of the ray tree cut off.
pub(crate) fn render(text: &str, width: u32, height: u32) -> Vec<[f64; 3]> {
    let file =
        scene_file::parse("scene.toml", text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    let mut buffer = Box::new(scene_file::Buffer::new());
    let mut scene = file
        .prepare(&mut buffer)
        .unwrap_or_else(|error| panic!("{error}\n{text}"));
    scene.set_min_weight(Real::ZERO).unwrap();
    let picture = render::linear(&scene, Size::new(width, height));
    let channel = |value: u16| f64::from(value) / 65535.0;
    picture
        .pixels
        .iter()
        .map(|p| [channel(p.r), channel(p.g), channel(p.b)])
        .collect()
}
