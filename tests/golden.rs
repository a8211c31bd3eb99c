//! Golden pictures, compared bit for bit: one PNG for each display color type, and
//! the checksums of all scenes.
//!
//! `BLESS=1 cargo test --test all golden` rewrites the files; inspect them before you
//! commit them.

use std::fmt::Write;
use std::fs;
use std::path::PathBuf;

use embedded_graphics::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, Rgb555, Rgb565, Rgb666,
    Rgb888,
};
use embedded_graphics::prelude::*;
use whitted::render::{
    AaSample, AntialiasedRenderer, DisplayColor, Dither, Output, SampleCount, Transfer,
};
use whitted::{Color, Renderer};
use whitted_sim::picture::Picture;
use whitted_sim::{png16, render, scene_file};

use crate::random_scenes::generator;

const SIZE: Size = Size::new(96, 72);

const DITHERED: Output = Output {
    transfer: Transfer::Linear,
    dither: Dither::Ordered,
};
const NEAREST: Output = Output {
    dither: Dither::Off,
    ..DITHERED
};
const SRGB: Output = Output {
    transfer: Transfer::Srgb,
    ..DITHERED
};

/// Renders tests/scenes/whitted.toml in a display color type.
fn draw<C>(output: Output) -> Picture
where
    C: PixelColor + DisplayColor + From<BinaryColor> + Into<Rgb888>,
{
    let file = scene_file::load(concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/tests/scenes/whitted.toml"
    ))
    .unwrap();
    let mut buffer = Box::new(scene_file::Buffer::new());
    let scene = file.prepare(&mut buffer).unwrap();
    let mut renderer = Renderer::new(&scene, SIZE);
    renderer.set_output(output);
    let mut line = [C::from(BinaryColor::Off); SIZE.width as usize];
    let mut pixels = Vec::new();
    for y in 0..SIZE.height {
        renderer.render_line(y, &mut line);
        pixels.extend(line.map(|color| {
            let shown: Rgb888 = color.into();
            Color::new(shown.r(), shown.g(), shown.b()).map(|channel| u16::from(channel) * 257)
        }));
    }
    Picture {
        width: SIZE.width,
        height: SIZE.height,
        pixels,
    }
}

/// Compares a picture with its golden PNG.
#[track_caller]
fn check(name: &str, drawn: &Picture) {
    let path: PathBuf = [env!("CARGO_MANIFEST_DIR"), "tests", "golden", name]
        .iter()
        .collect();
    let path = path.with_extension("png");
    if std::env::var_os("BLESS").is_some() {
        png16::write(&path, drawn).unwrap();
    }
    let golden = png16::read(&path).unwrap();
    assert_eq!((golden.width, golden.height), (drawn.width, drawn.height));
    let differing = golden
        .pixels
        .iter()
        .zip(&drawn.pixels)
        .filter(|(a, b)| a != b)
        .count();
    assert_eq!(differing, 0, "pixels differ from {}", path.display());
}

macro_rules! golden {
    ($($name:ident: $color:ident, $output:ident;)*) => {$(
        #[test]
        fn $name() {
            check(stringify!($name), &draw::<$color>($output));
        }
    )*};
}

golden! {
    rgb565: Rgb565, NEAREST;
    rgb666: Rgb666, NEAREST;
    rgb888: Rgb888, DITHERED;
    gray8: Gray8, DITHERED;
    gray4: Gray4, NEAREST;
    gray2: Gray2, NEAREST;
    binary: BinaryColor, NEAREST;
    rgb565_dithered: Rgb565, DITHERED;
    rgb666_dithered: Rgb666, DITHERED;
    gray4_dithered: Gray4, DITHERED;
    gray2_dithered: Gray2, DITHERED;
    binary_dithered: BinaryColor, DITHERED;
    rgb888_srgb: Rgb888, SRGB;
    rgb565_srgb: Rgb565, SRGB;
    gray4_srgb: Gray4, SRGB;
}

#[test]
fn antialiased() {
    const WHITTED: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/scenes/whitted.toml");
    let file = scene_file::load(WHITTED).unwrap();
    let mut buffer = Box::new(scene_file::Buffer::new());
    let scene = file.prepare(&mut buffer).unwrap();
    let mut memory = [AaSample::BLACK; 2 * SIZE.width as usize];
    for (name, samples) in [
        ("rays4", SampleCount::Four),
        ("rays16", SampleCount::Sixteen),
    ] {
        let mut renderer = AntialiasedRenderer::new(&scene, SIZE, samples, &mut memory).unwrap();
        let drawn = render::lines(SIZE, |y, line| renderer.render_line(y, line));
        check(name, &drawn);
    }
}

/// Draws every scene of `tests/scenes` and a hundred random ones at 64x48. Returns a
/// line for each, with the CRC-32 of its 16-bit linear channels and its name.
fn checksums() -> String {
    const SIZE: Size = Size::new(64, 48);
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/scenes");
    let mut files: Vec<PathBuf> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|it| it == "toml"))
        .collect();
    files.sort();
    let scenes = files.into_iter().map(|path| {
        let name = path.file_stem().unwrap().display().to_string();
        (name, fs::read_to_string(path).unwrap())
    });
    let random = (0..100).map(|seed| (format!("random {seed}"), generator::scene(seed).toml));
    let mut buffer = Box::new(scene_file::Buffer::new());
    let mut lines = String::new();
    for (name, toml) in scenes.chain(random) {
        let file = scene_file::parse(&name, &toml).unwrap();
        let picture = render::linear(&file.prepare(&mut buffer).unwrap(), SIZE);
        let checksum = render::checksum(&picture);
        writeln!(lines, "{checksum:08x} {name}").unwrap();
    }
    lines
}

#[test]
fn scene_checksums() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/golden/checksums.txt");
    let drawn = checksums();
    if std::env::var_os("BLESS").is_some() {
        fs::write(path, &drawn).unwrap();
    }
    let golden = fs::read_to_string(path).unwrap();
    let pairs = drawn.lines().zip(golden.lines());
    let changed: Vec<_> = pairs.filter(|(drawn, golden)| drawn != golden).collect();
    assert!(
        drawn == golden,
        "drawn and golden checksums differ: {changed:#?}"
    );
}

#[test]
fn bgr_formats_show_same_colors_as_rgb() {
    assert_eq!(draw::<Bgr555>(DITHERED), draw::<Rgb555>(DITHERED));
    assert_eq!(draw::<Bgr565>(DITHERED), draw::<Rgb565>(DITHERED));
    assert_eq!(draw::<Bgr666>(DITHERED), draw::<Rgb666>(DITHERED));
    assert_eq!(draw::<Bgr888>(DITHERED), draw::<Rgb888>(DITHERED));
}
