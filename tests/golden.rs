//! Pictures that must not change by a bit: what each kind of display is sent.
//!
//! `BLESS=1 cargo test --test golden` writes them anew; look at them before
//! they are committed.

#![allow(clippy::unwrap_used)]

use std::path::PathBuf;

use embedded_graphics::pixelcolor::{
    Bgr565, Bgr888, BinaryColor, Gray2, Gray4, Gray8, Rgb565, Rgb666, Rgb888,
};
use embedded_graphics::prelude::*;
use whitted::{Color, Pixel, Renderer};
use whitted_sim::picture::Picture;
use whitted_sim::{png16, scene_file};

const SIZE: Size = Size::new(96, 72);

fn draw<C: PixelColor + Pixel + Into<Rgb888>>() -> Picture {
    let file =
        scene_file::load(concat!(env!("CARGO_MANIFEST_DIR"), "/scenes/whitted.toml")).unwrap();
    let mut buffer = Box::new(scene_file::Buffer::new());
    let scene = file.prepare(&mut buffer).unwrap();
    let mut renderer = Renderer::new(&scene, SIZE);
    let mut line = [C::from_linear(Color::default()); SIZE.width as usize];
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
    ($($color:ident: $name:ident),*) => {$(
        #[test]
        fn $name() {
            check(stringify!($name), &draw::<$color>());
        }
    )*};
}

golden! {
    Rgb565: rgb565,
    Rgb666: rgb666,
    Rgb888: rgb888,
    Gray8: gray8,
    Gray4: gray4,
    Gray2: gray2,
    BinaryColor: binary
}

#[test]
fn blue_first_formats_look_like_their_red_first_ones() {
    assert_eq!(draw::<Bgr565>(), draw::<Rgb565>());
    assert_eq!(draw::<Bgr888>(), draw::<Rgb888>());
}
