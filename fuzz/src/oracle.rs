use embedded_graphics_core::geometry::Size;
use whitted::Color;
use whitted_sim::compare::compare;
use whitted_sim::picture::Picture;
use whitted_sim::render;
use whitted_sim::scene_file::{self, Buffer};

#[path = "../../tests/random_scenes/generator.rs"]
#[allow(dead_code, reason = "other tests use the rest of the module")]
mod generator;

const WIDTH: u32 = 16;
const HEIGHT: u32 = 12;

/// Least fraction of pixels that must match.
///
/// At 16x12 pixels, rounding at edges changes many pixels. A real error changes nearly all.
const MIN_MATCHING: f64 = 0.75;

/// Compares the random scene of a seed with the reference tracer in double precision.
pub fn oracle(input: &[u8]) {
    let seed = input.iter().fold(0, |seed: u64, byte| {
        seed.wrapping_mul(257).wrapping_add(u64::from(*byte) + 1)
    });
    let toml = generator::scene(seed).toml;
    let file =
        scene_file::parse("scene.toml", &toml).expect("the generator writes a valid scene file");
    let mut buffer = Box::new(Buffer::new());
    let scene = file
        .prepare(&mut buffer)
        .expect("the generator writes a valid scene");
    let drawn = render::linear(&scene, Size::new(WIDTH, HEIGHT));
    let comparison = compare(&drawn, &expected(&toml)).expect("both pictures have the same size");
    assert!(
        comparison.within >= MIN_MATCHING,
        "seed {seed}: {comparison}\n{toml}"
    );
}

/// Renders the scene with the reference tracer.
fn expected(toml: &str) -> Picture {
    let sample = |channel: f64| (65535.0 * channel.clamp(0.0, 1.0)).round() as u16;
    let pixels = whitted_oracle::parse::<f64>(toml).render(WIDTH, HEIGHT);
    let pixels = pixels.into_iter().map(|color| color.map(sample));
    Picture {
        width: WIDTH,
        height: HEIGHT,
        pixels: pixels.map(|[r, g, b]| Color::new(r, g, b)).collect(),
    }
}
