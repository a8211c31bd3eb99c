use embedded_graphics_core::geometry::Size;
use whitted::Color;
use whitted_sim::compare::compare;
use whitted_sim::picture::Picture;
use whitted_sim::render;
use whitted_sim::scene_file::{self, Buffer};

#[path = "../../tests/random_scenes/generator.rs"]
#[allow(dead_code, reason = "its tests ask more of it")]
mod generator;

const WIDTH: u32 = 16;
const HEIGHT: u32 = 12;

/// At this size an edge that falls to the other side takes much; what is wrong
/// by more than that takes nearly all.
const LEAST_WITHIN: f64 = 0.75;

/// The random scene of any seed looks as in double precision.
pub fn oracle(input: &[u8]) {
    let seed = input.iter().fold(0, |seed: u64, byte| {
        seed.wrapping_mul(257).wrapping_add(u64::from(*byte) + 1)
    });
    let toml = generator::scene(seed).toml;
    let file = scene_file::parse("scene.toml", &toml).expect("a scene file");
    let mut buffer = Box::new(Buffer::new());
    let scene = file.prepare(&mut buffer).expect("a valid scene");
    let drawn = render::linear(&scene, Size::new(WIDTH, HEIGHT));
    let comparison = compare(&drawn, &expected(&toml)).expect("one size");
    assert!(
        comparison.within >= LEAST_WITHIN,
        "seed {seed}: {comparison}\n{toml}"
    );
}

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
