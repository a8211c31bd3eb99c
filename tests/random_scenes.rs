//! Compares a thousand random scenes with the double-precision oracle, which has
//! its own scene file parser.
//!
//! The scenes with the lowest PSNR have a checkered floor up to the horizon, which
//! is aliased. Directions are rounded to 2^-30; near the horizon, that is enough
//! to move single pixels into the neighboring square.
//!
//! The environment variable `SCENES=100` reduces the number of scenes; the limits
//! stay. `SEED=17 cargo test --test all random_scenes -- --nocapture` prints one scene
//! file and its comparison, and writes both pictures as seed-17.png and
//! seed-17-oracle.png.

pub(crate) mod generator;

use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;

use embedded_graphics::geometry::Size;
use generator::RandomScene;
use whitted::observer::{Observer, RayKind, RayNode};
use whitted::{Color, Renderer};
use whitted_sim::compare::{Comparison, compare};
use whitted_sim::picture::Picture;
use whitted_sim::{png16, render, scene_file};

/// Default number of scenes.
const SCENES: u64 = 1000;
const SIZE: Size = Size::new(320, 240);

/// Counts the camera rays that hit an object.
#[derive(Default)]
struct Coverage(u32);

impl Observer for Coverage {
    fn node(&mut self, node: &RayNode) {
        self.0 += u32::from(node.kind == RayKind::Camera && node.object.is_some());
    }
}

struct Outcome {
    seed: u64,
    comparison: Comparison,
    /// True if a material reflects or transmits.
    bounces: bool,
    /// Fraction of pixels that show an object.
    covered: f64,
}

impl Outcome {
    fn of(seed: u64) -> Self {
        let RandomScene { toml, bounces } = generator::scene(seed);
        let (picture, covered) = rendered(seed, &toml);
        Self {
            seed,
            comparison: compare(&picture, &expected(&toml)).unwrap(),
            bounces,
            covered,
        }
    }
}

/// Renders with the library. Returns the picture and the fraction of pixels that
/// show an object.
fn rendered(seed: u64, toml: &str) -> (Picture, f64) {
    let file = scene_file::parse("scene.toml", toml)
        .unwrap_or_else(|error| panic!("seed {seed}: {error}\n{toml}"));
    let mut buffer = Box::new(scene_file::Buffer::new());
    let scene = file
        .prepare(&mut buffer)
        .unwrap_or_else(|error| panic!("seed {seed}: {error}\n{toml}"));
    let mut renderer = Renderer::with_observer(&scene, SIZE, Coverage::default());
    let picture = render::trace(&mut renderer, |_| {});
    let covered = f64::from(renderer.observer().0) / f64::from(SIZE.width * SIZE.height);
    (picture, covered)
}

/// Renders with the oracle.
fn expected(toml: &str) -> Picture {
    let pixels = whitted_oracle::parse::<f64>(toml).render(SIZE.width, SIZE.height);
    let sample = |channel: f64| (65535.0 * channel.clamp(0.0, 1.0)).round() as u16;
    Picture {
        width: SIZE.width,
        height: SIZE.height,
        pixels: pixels
            .into_iter()
            .map(|color| color.map(sample))
            .map(|[r, g, b]| Color::new(r, g, b))
            .collect(),
    }
}

/// Reads a number from an environment variable.
fn number_from_env(variable: &str) -> Option<u64> {
    std::env::var(variable).ok()?.parse().ok()
}

/// Compares all scenes, with one thread per core.
fn outcomes() -> Vec<Outcome> {
    let next = AtomicU64::new(0);
    let scenes = number_from_env("SCENES").unwrap_or(SCENES);
    let work = || {
        let seeds = std::iter::repeat_with(|| next.fetch_add(1, Ordering::Relaxed));
        seeds
            .take_while(|seed| *seed < scenes)
            .map(Outcome::of)
            .collect::<Vec<_>>()
    };
    thread::scope(|scope| {
        let cores = thread::available_parallelism().map_or(1, usize::from);
        let threads = (0..cores).map(|_| scope.spawn(work)).collect::<Vec<_>>();
        threads
            .into_iter()
            .flat_map(|thread| thread.join().unwrap())
            .collect()
    })
}

/// Prints a histogram in steps of 10 dB and the 20 worst scenes.
fn print_outcomes(sorted: &[Outcome]) {
    for low in (30..110).step_by(10) {
        let count = sorted
            .iter()
            .filter(|outcome| (outcome.comparison.psnr.min(109.0) / 10.0) as i32 * 10 == low)
            .count();
        println!("{low:3} dB {count:4} {}", "#".repeat(count.div_ceil(10)));
    }
    for Outcome {
        seed, comparison, ..
    } in sorted.iter().take(20)
    {
        println!("seed {seed}: {comparison}");
    }
}

#[test]
fn random_scenes_match_oracle() {
    if let Some(seed) = number_from_env("SEED") {
        let toml = generator::scene(seed).toml;
        println!("{toml}");
        png16::write(format!("seed-{seed}.png"), &rendered(seed, &toml).0).unwrap();
        png16::write(format!("seed-{seed}-oracle.png"), &expected(&toml)).unwrap();
        print_outcomes(&[Outcome::of(seed)]);
        return;
    }
    let mut outcomes = outcomes();
    outcomes.sort_by(|a, b| a.comparison.psnr.total_cmp(&b.comparison.psnr));
    print_outcomes(&outcomes);
    let median = outcomes[outcomes.len() / 2].comparison.psnr;
    let worst = outcomes[0].comparison.psnr;
    let bouncing = outcomes.iter().filter(|outcome| outcome.bounces).count();
    let covered = outcomes
        .iter()
        .map(|outcome| outcome.covered)
        .fold(1.0, f64::min);
    println!(
        "figure: {} scenes, median {median:.1} dB, worst {worst:.1} dB; {bouncing} with reflection or refraction; objects on at least {:.0} % of the pixels",
        outcomes.len(),
        100.0 * covered
    );
    assert!(
        worst > 46.0 && median > 99.0,
        "worst {worst:.1} dB, median {median:.1} dB"
    );
    assert!(
        2 * bouncing >= outcomes.len(),
        "only {bouncing} scenes reflect or refract"
    );
    assert!(
        3.0 * covered >= 1.0,
        "objects on only {covered} of the pixels"
    );
}
