//! Smooth edges: how near they come to the mean of 64 rays a pixel, and what
//! that costs. `cargo test --test antialias -- --nocapture` prints the table of
//! docs/antialiasing.md.

#![allow(clippy::unwrap_used)]

use std::fs;

use embedded_graphics::prelude::*;
use whitted::observer::{Observer, RayKind};
use whitted::render::{AaSample, AntialiasedRenderer, SampleCount};
use whitted::{Color, PreparedScene, Renderer};
use whitted_sim::scene_file;

const SIZE: Size = Size::new(320, 240);

/// Rays of any kind.
#[derive(Default)]
struct Rays(u64);

impl Observer for Rays {
    fn ray(&mut self, _: RayKind) {
        self.0 += 1;
    }
}

/// Linear channels, pixel by pixel, and the rays that they took.
type Picture = (Vec<f64>, u64);

fn channels(pixels: &[Color<u16>]) -> impl Iterator<Item = f64> {
    let channels = pixels.iter().flat_map(|color| [color.r, color.g, color.b]);
    channels.map(|channel| f64::from(channel) / 65_535.0)
}

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

fn smooth(scene: &PreparedScene<'_>, samples: SampleCount) -> Picture {
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

/// The mean of 8x8 rays a pixel.
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

fn decibels(a: &[f64], b: &[f64]) -> f64 {
    let squares: f64 = a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum();
    -10.0 * (squares / a.len() as f64).log10()
}

/// What more rays bring.
#[derive(Debug)]
struct Gain {
    decibels: f64,
    rays: f64,
}

/// Prints a row of the table.
fn gains(name: &str) -> [Gain; 2] {
    let path = format!(
        "{}/tests/reference/scenes/{name}.toml",
        env!("CARGO_MANIFEST_DIR")
    );
    let file = scene_file::parse(name, &fs::read_to_string(path).unwrap()).unwrap();
    let mut buffer = Box::new(scene_file::Buffer::new());
    let scene = file.prepare(&mut buffer).unwrap();

    let reference = reference(&scene);
    let (picture, rays) = plain(&scene, SIZE);
    let before = decibels(&picture, &reference);
    let gains = [SampleCount::Four, SampleCount::Sixteen].map(|samples| {
        let (picture, more) = smooth(&scene, samples);
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

#[test]
fn whitted() {
    let [four, sixteen] = gains("01_whitted");
    // What is promised is 5 dB for at most 2.2 times the rays.
    assert!(four.decibels > 10.0 && four.rays < 2.1, "{four:?}");
    assert!(sixteen.decibels > 16.0 && sixteen.rays < 5.2, "{sixteen:?}");
}

#[test]
fn cone() {
    let [four, sixteen] = gains("07_cone");
    assert!(four.decibels > 9.5 && four.rays < 1.6, "{four:?}");
    assert!(sixteen.decibels > 17.5 && sixteen.rays < 3.2, "{sixteen:?}");
}

#[test]
fn mirrors() {
    let [four, sixteen] = gains("10_mirrors_d3");
    assert!(four.decibels > 9.5 && four.rays < 2.2, "{four:?}");
    assert!(sixteen.decibels > 14.0 && sixteen.rays < 5.5, "{sixteen:?}");
}

#[test]
fn glass_indices() {
    let [four, sixteen] = gains("11_glass_indices");
    assert!(four.decibels > 9.5 && four.rays < 2.7, "{four:?}");
    assert!(sixteen.decibels > 14.5 && sixteen.rays < 7.7, "{sixteen:?}");
}

#[test]
fn sphereflake() {
    let [four, sixteen] = gains("13_flake_d3");
    assert!(four.decibels > 8.8 && four.rays < 3.7, "{four:?}");
    assert!(
        sixteen.decibels > 15.0 && sixteen.rays < 11.5,
        "{sixteen:?}"
    );
}
