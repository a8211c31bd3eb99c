//! Antialiasing: its PSNR against the mean of 64 rays per pixel, and its cost in
//! rays. `cargo test --test all antialias -- --nocapture` prints the table of
//! docs/antialiasing.md.

use embedded_graphics::prelude::*;
use whitted::observer::{Observer, RayKind};
use whitted::render::{AaSample, AntialiasedRenderer, SampleCount};
use whitted::{Color, PreparedScene, Renderer};
use whitted_sim::scene_file;

use crate::common::reference_scene;

const SIZE: Size = Size::new(320, 240);

/// Number of rays of all kinds.
#[derive(Default)]
struct Rays(u64);

impl Observer for Rays {
    fn ray(&mut self, _: RayKind) {
        self.0 += 1;
    }
}

/// Linear channels, pixel by pixel, and the number of rays traced for them.
type Picture = (Vec<f64>, u64);

fn channels(pixels: &[Color<u16>]) -> impl Iterator<Item = f64> {
    let channels = pixels.iter().flat_map(|color| [color.r, color.g, color.b]);
    channels.map(|channel| f64::from(channel) / 65_535.0)
}

/// Renders with one ray per pixel.
fn plain(scene: &PreparedScene<'_>, size: Size) -> Picture {
    let mut renderer = Renderer::with_observer(scene, size, Rays::default());
    let mut line = vec![Color::default(); size.width as usize];
    let mut picture = Vec::new();
    for y in 0..size.height {
        renderer.render_line(y, &mut line);
        picture.extend(channels(&line));
    }
    (picture, renderer.observer().0)
}

/// Renders with antialiasing.
fn antialiased(scene: &PreparedScene<'_>, samples: SampleCount) -> Picture {
    let mut memory = vec![AaSample::BLACK; 2 * SIZE.width as usize];
    let mut renderer =
        AntialiasedRenderer::with_observer(scene, SIZE, samples, &mut memory, Rays::default())
            .unwrap();
    let mut line = vec![Color::default(); SIZE.width as usize];
    let mut picture = Vec::new();
    for y in 0..SIZE.height {
        renderer.render_line(y, &mut line);
        picture.extend(channels(&line));
    }
    (picture, renderer.observer().0)
}

/// Returns the mean of 8x8 rays per pixel.
fn reference(scene: &PreparedScene<'_>) -> Vec<f64> {
    let (fine, _) = plain(scene, SIZE * 8);
    let (width, row) = (3 * SIZE.width as usize, 3 * 8 * SIZE.width as usize);
    let mut mean = vec![0.0; width * SIZE.height as usize];
    for (y, fine) in fine.chunks_exact(row).enumerate() {
        let line = &mut mean[y / 8 * width..][..width];
        for (at, channel) in fine.iter().enumerate() {
            line[at / 24 * 3 + at % 3] += channel / 64.0;
        }
    }
    mean
}

/// Returns the PSNR of two pictures in dB.
fn decibels(a: &[f64], b: &[f64]) -> f64 {
    let squares: f64 = a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum();
    -10.0 * (squares / a.len() as f64).log10()
}

/// Gain of antialiasing over one ray per pixel.
#[derive(Debug)]
struct Gain {
    /// Gain in PSNR, in dB.
    decibels: f64,
    /// Number of rays, relative to the plain picture.
    rays: f64,
}

/// Measures a reference scene with 4 and with 16 rays per edge pixel, and prints
/// its row of the table.
fn gains(name: &str) -> [Gain; 2] {
    let text = reference_scene::text(concat!(env!("CARGO_MANIFEST_DIR"), "/tests"), name);
    let file = scene_file::parse(name, &text).unwrap();
    let mut buffer = Box::new(scene_file::Buffer::new());
    let scene = file.prepare(&mut buffer).unwrap();

    let reference = reference(&scene);
    let (picture, rays) = plain(&scene, SIZE);
    let before = decibels(&picture, &reference);
    let gains = [SampleCount::Four, SampleCount::Sixteen].map(|samples| {
        let (picture, more) = antialiased(&scene, samples);
        Gain {
            decibels: decibels(&picture, &reference) - before,
            rays: more as f64 / rays as f64,
        }
    });
    let [four, sixteen] = &gains;
    println!(
        "| {name} | {before:.1} dB | +{:.1} dB | {:.2} | +{:.1} dB | {:.2} |",
        four.decibels, four.rays, sixteen.decibels, sixteen.rays
    );
    gains
}

/// Checks the gains with 4 and with 16 rays per edge pixel: each must exceed
/// `decibels` and stay below `rays`.
fn check(name: &str, limits: [Gain; 2]) {
    for (gain, limit) in gains(name).iter().zip(&limits) {
        assert!(
            gain.decibels > limit.decibels && gain.rays < limit.rays,
            "{gain:?}, limit {limit:?}"
        );
    }
}

macro_rules! gains {
    ($($test:ident: $name:literal, $db4:literal dB at $rays4:literal, $db16:literal dB at $rays16:literal;)*) => {$(
        #[test]
        fn $test() {
            let four = Gain { decibels: $db4, rays: $rays4 };
            let sixteen = Gain { decibels: $db16, rays: $rays16 };
            check($name, [four, sixteen]);
        }
    )*};
}

// docs/antialiasing.md promises 5 dB for at most 2.2 times the rays of `whitted`.
gains! {
    whitted: "whitted", 10.0 dB at 2.1, 16.0 dB at 5.2;
    cone: "cones", 9.5 dB at 1.6, 17.5 dB at 3.2;
    mirrors: "mirrors_depth_3", 9.5 dB at 2.2, 14.0 dB at 5.5;
    glass_indices: "glass_indices", 9.5 dB at 2.7, 14.5 dB at 7.7;
    sphereflake: "sphereflake_3", 8.8 dB at 3.7, 15.0 dB at 11.5;
}
