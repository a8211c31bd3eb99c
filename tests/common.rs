//! Renders scene files with the library, for comparison with the oracle.

pub(crate) mod line_display;
pub(crate) mod mirror_ball;
pub(crate) mod reference_scene;
pub(crate) mod window;

use embedded_graphics::geometry::Size;
use whitted::observer::Observer;
use whitted::{Real, Renderer};
use whitted_sim::{render, scene_file};

/// Returns linear colors from 0 to 1, row by row. `min_weight` is set to 0, so
/// that no ray is dropped for its small weight.
pub(crate) fn render(text: &str, width: u32, height: u32) -> Vec<[f64; 3]> {
    observe(text, [width, height], ()).0
}

/// Renders like [`render`] and also returns the observer.
pub(crate) fn observe<O: Observer + Clone>(
    text: &str,
    [width, height]: [u32; 2],
    observer: O,
) -> (Vec<[f64; 3]>, O) {
    let file =
        scene_file::parse("scene.toml", text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    let mut buffer = Box::new(scene_file::Buffer::new());
    let mut scene = file
        .prepare(&mut buffer)
        .unwrap_or_else(|error| panic!("{error}\n{text}"));
    scene.set_min_weight(Real::ZERO).unwrap();
    let mut renderer = Renderer::with_observer(&scene, Size::new(width, height), observer);
    let picture = render::trace(&mut renderer, |_| {});
    let channel = |value: u16| f64::from(value) / 65535.0;
    let pixels = picture
        .pixels
        .iter()
        .map(|p| [channel(p.r), channel(p.g), channel(p.b)])
        .collect();
    (pixels, renderer.observer().clone())
}
