//! A thousand random scenes against the double-precision oracle, which reads
//! the same scene files by itself.
//!
//! The low tail are scenes with a checkered floor up to the horizon, which is
//! aliased: a direction is known to 2^-30, and where a pixel's row of cells is
//! narrower than that leaves them, single pixels fall to the other cell.
//!
//! `SCENES=100` takes fewer of them, of which the same must hold.
//! `SEED=17 cargo test --test random_scenes -- --nocapture` prints a scene file
//! and how like the two pictures of it are, and writes them as seed-17.png and
//! seed-17-oracle.png.

#![allow(clippy::unwrap_used)]

mod generator;

use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;

use embedded_graphics::geometry::Size;
use generator::RandomScene;
use whitted::observer::{Observer, RayKind, RayNode};
use whitted::{Color, Renderer};
use whitted_sim::compare::{Comparison, compare};
use whitted_sim::picture::Picture;
use whitted_sim::{png16, render, scene_file};

/// Unless told otherwise.
const SCENES: u64 = 1000;
const SIZE: Size = Size::new(320, 240);

/// Pixels that show an object.
#[derive(Default)]
struct Covered(u32);

impl Observer for Covered {
    fn node(&mut self, node: &RayNode) {
        self.0 += u32::from(node.kind == RayKind::Camera && node.object.is_some());
    }
}

struct Outcome {
    seed: u64,
    comparison: Comparison,
    bounces: bool,
    /// The share of pixels that show an object.
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

/// The library's picture, and the share of pixels that show an object.
fn rendered(seed: u64, toml: &str) -> (Picture, f64) {
    let file = scene_file::parse("scene.toml", toml)
        .unwrap_or_else(|error| panic!("seed {seed}: {error}\n{toml}"));
    let mut buffer = Box::new(scene_file::Buffer::new());
    let scene = file
        .prepare(&mut buffer)
        .unwrap_or_else(|error| panic!("seed {seed}: {error}\n{toml}"));
    let mut renderer = Renderer::with_observer(&scene, SIZE, Covered::default());
    let picture = render::trace(&mut renderer, |_| {});
    let covered = f64::from(renderer.observer().0) / f64::from(SIZE.width * SIZE.height);
    (picture, covered)
}

/// The oracle's picture.
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

/// A number of whoever runs the test.
fn told(variable: &str) -> Option<u64> {
    std::env::var(variable).ok()?.parse().ok()
}

/// All seeds, by as many threads as there are cores.
fn outcomes() -> Vec<Outcome> {
    let next = AtomicU64::new(0);
    let scenes = told("SCENES").unwrap_or(SCENES);
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

/// How many are in each ten decibels, and which are the worst.
fn print(sorted: &[Outcome]) {
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
fn random_scenes_agree_with_the_oracle() {
    if let Some(seed) = told("SEED") {
        let toml = generator::scene(seed).toml;
        println!("{toml}");
        png16::write(format!("seed-{seed}.png"), &rendered(seed, &toml).0).unwrap();
        png16::write(format!("seed-{seed}-oracle.png"), &expected(&toml)).unwrap();
        print(&[Outcome::of(seed)]);
        return;
    }
    let mut outcomes = outcomes();
    outcomes.sort_by(|a, b| a.comparison.psnr.total_cmp(&b.comparison.psnr));
    print(&outcomes);
    let median = outcomes[outcomes.len() / 2].comparison.psnr;
    let worst = outcomes[0].comparison.psnr;
    let bouncing = outcomes.iter().filter(|outcome| outcome.bounces).count();
    let covered = outcomes
        .iter()
        .map(|outcome| outcome.covered)
        .fold(1.0, f64::min);
    println!(
        "figure: {} scenes, median {median:.1} dB, worst {worst:.1} dB; {bouncing} reflect or refract; objects on {:.0} % of the pixels at least",
        outcomes.len(),
        100.0 * covered
    );
    assert!(
        worst > 46.0 && median > 99.0,
        "worst {worst:.1} dB, median {median:.1} dB"
    );
    assert!(
        2 * bouncing >= outcomes.len(),
        "{bouncing} scenes reflect or refract"
    );
    assert!(3.0 * covered >= 1.0, "objects on {covered} of the pixels");
}
