//! The examples draw the right pictures, and `docs/images/examples` shows them.
//!
//! Each example is compiled into this test as a module. After a change of an example, write
//! its picture again: `cargo run --example NAME -- docs/images/examples/NAME.png`.

#![allow(dead_code, reason = "no test calls the examples' main functions")]

#[path = "../examples/animation.rs"]
mod animation;
#[path = "../examples/antialiased.rs"]
mod antialiased;
#[path = "../examples/async.rs"]
mod async_lines;
#[path = "../examples/compiled_scene.rs"]
mod compiled_scene;
#[path = "../examples/dma_lines.rs"]
mod dma_lines;
#[path = "../examples/first_scene.rs"]
mod first_scene;
#[path = "../examples/over_interface.rs"]
mod over_interface;
#[path = "../examples/progressive.rs"]
mod progressive;
#[path = "../examples/two_renderers.rs"]
mod two_renderers;

use std::fs::File;
use std::io::BufReader;
use std::path::Path;

use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
use embedded_graphics::prelude::*;
use whitted::animation::Keyframe;
use whitted::{DecodeError, Object, Real, Renderer, Scene, SceneBuffer, Vec3, real};

use progressive::common::scene::{SCENE, SIZE};

/// Draws a scene line by line from the bottom to the top, without a display.
fn lines_of(scene: &Scene<'_>, size: Size) -> Vec<Rgb565> {
    let mut buffer = SceneBuffer::<8, 2, 8>::new();
    let scene = buffer.prepare(scene).unwrap();
    let mut renderer = Renderer::new(&scene, size);
    let mut pixels = vec![Rgb565::BLACK; (size.width * size.height) as usize];
    let lines = pixels.chunks_exact_mut(size.width as usize);
    for (y, line) in lines.enumerate().rev() {
        renderer.render_line(y as u32, line);
    }
    pixels
}

#[test]
fn first_scene_draws_its_scene() {
    let display = first_scene::picture().unwrap();
    assert_eq!(display.pixels, lines_of(&first_scene::SCENE, display.size));
}

#[test]
fn progressive_ends_with_the_plain_picture() {
    let ([first_pass, at_press, end], watchdog_feeds) = progressive::pictures().unwrap();
    assert_eq!(end.pixels, lines_of(&SCENE, SIZE));

    // The button interrupts the picture after 3 steps, and many more complete it.
    assert_ne!(at_press.pixels, first_pass.pixels);
    assert_ne!(at_press.pixels, end.pixels);
    assert!(watchdog_feeds > 50, "{watchdog_feeds} steps");
}

#[test]
fn first_pass_shows_blocks_of_16_pixels() {
    let ([first_pass, ..], _) = progressive::pictures().unwrap();
    let end = lines_of(&SCENE, SIZE);
    let width = SIZE.width as usize;
    for (index, &pixel) in first_pass.pixels.iter().enumerate() {
        let (x, y) = (index % width, index / width);
        let corner = end[y / 16 * 16 * width + x / 16 * 16];
        // A block has one color, which dithering shows as one of two levels in each pixel.
        let levels = |color: Rgb565| [color.r(), color.g(), color.b()];
        let pairs = levels(pixel).into_iter().zip(levels(corner));
        let tolerance = u8::from((x % 16, y % 16) != (0, 0));
        let is_equal = pairs.into_iter().all(|(a, b)| a.abs_diff(b) <= tolerance);
        assert!(is_equal, "({x}, {y}): {pixel:?} instead of {corner:?}");
    }
}

#[test]
fn antialiased_smooths_edges_and_leaves_other_pixels() {
    let [plain, smooth] = antialiased::pictures().unwrap();
    assert_eq!(plain.pixels, lines_of(&antialiased::SCENE, plain.size));

    let pairs = plain.pixels.iter().zip(&smooth.pixels);
    let equal = pairs.filter(|(plain, smooth)| plain == smooth).count();
    assert!(equal > plain.pixels.len() / 4, "{equal} pixels are equal");

    let reference = supersampled(&antialiased::SCENE, plain.size);
    let (plain, smooth) = (
        error(&plain.pixels, &reference),
        error(&smooth.pixels, &reference),
    );
    assert!(2 * smooth < plain, "squared error {smooth}, plain {plain}");
}

/// Draws a scene with 64 rays a pixel and returns the mean of each pixel's channels.
fn supersampled(scene: &Scene<'_>, size: Size) -> Vec<[u32; 3]> {
    let fine = lines_of(scene, size * 8);
    let width = size.width as usize;
    let mut sums = vec![[0; 3]; width * size.height as usize];
    for (index, &pixel) in fine.iter().enumerate() {
        let (x, y) = (index % (8 * width) / 8, index / (8 * width) / 8);
        for (sum, channel) in sums[y * width + x].iter_mut().zip(channels(pixel)) {
            *sum += channel;
        }
    }
    sums.iter().map(|sums| sums.map(|sum| sum / 64)).collect()
}

/// Returns the sum of squared differences of 8-bit channels.
fn error(pixels: &[Rgb565], reference: &[[u32; 3]]) -> u32 {
    let pixels = pixels.iter().map(|&pixel| channels(pixel));
    let pairs = pixels
        .zip(reference)
        .flat_map(|(a, b)| a.into_iter().zip(*b));
    pairs.map(|(a, b)| a.abs_diff(b).pow(2)).sum()
}

fn channels(pixel: Rgb565) -> [u32; 3] {
    let pixel = Rgb888::from(pixel);
    [pixel.r(), pixel.g(), pixel.b()].map(u32::from)
}

#[test]
fn animation_moves_ball_and_light_to_the_keyframes() {
    let [ball, light] = animation::HOPS.tracks else {
        panic!("the animation has other tracks");
    };
    let key = |keys: &[Keyframe], time| {
        let mut keys = keys.iter();
        keys.find(|key| key.time == time).unwrap().value
    };
    for time in [Real::ZERO, Real::ONE] {
        let expected = moved(key(ball.keys, time), key(light.keys, time));
        assert_eq!(animation::frame(time).unwrap().pixels, expected);
    }
    let start = animation::frame(Real::ZERO).unwrap();
    assert_eq!(animation::frame(real!(2)).unwrap(), start);
    assert_ne!(animation::frame(Real::ONE).unwrap(), start);
}

/// Draws the scene of the animation with its ball and its light elsewhere.
fn moved(ball: Vec3<Real>, light: Vec3<Real>) -> Vec<Rgb565> {
    let mut objects = animation::SCENE.objects.to_vec();
    let mut lights = animation::SCENE.lights.to_vec();
    objects[1] = Object::sphere(ball, real!(0.5), whitted::MaterialId(0));
    lights[0].position = light;
    let scene = Scene {
        objects: &objects,
        lights: &lights,
        ..animation::SCENE
    };
    lines_of(&scene, Size::new(120, 120))
}

#[test]
fn dma_lines_sends_each_line_once_complete() {
    assert_eq!(dma_lines::picture().unwrap().pixels, lines_of(&SCENE, SIZE));
}

#[test]
fn async_draws_while_the_led_blinks() {
    let (display, blinks) = async_lines::picture().unwrap();
    assert_eq!(display.pixels, lines_of(&SCENE, SIZE));
    assert_eq!(blinks, SIZE.height, "once a line");
}

#[test]
fn two_renderers_draw_what_one_draws() {
    let mut buffer = SceneBuffer::<8, 2, 8>::new();
    let scene = buffer.prepare(&SCENE).unwrap();
    let two = two_renderers::draw_with_two(&scene);
    assert_eq!(two, two_renderers::draw_with_one(&scene));
    assert_eq!(two.pixels, lines_of(&SCENE, SIZE));
}

#[test]
fn compiled_scene_decodes_to_the_picture() {
    let mut bytes = compiled_scene::compile().unwrap();
    let display = compiled_scene::draw(&bytes).unwrap();
    assert_eq!(display.pixels, lines_of(&SCENE, SIZE));

    let middle = bytes.len() / 2;
    bytes[middle] ^= 1;
    let error = compiled_scene::draw(&bytes).unwrap_err();
    assert!(error.is::<DecodeError>(), "{error}");
}

/// Reads a PNG file: its size and its bytes.
fn read_png(path: &Path) -> (u32, u32, Vec<u8>) {
    let file = File::open(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let mut reader = png::Decoder::new(BufReader::new(file)).read_info().unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut bytes).unwrap();
    (info.width, info.height, bytes)
}

/// Writes a picture as an example does, and compares it with the one in the documentation.
macro_rules! assert_documented {
    ($example:ident, $scale:literal, $displays:expr) => {
        let name = concat!(stringify!($example), ".png");
        let written = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
        $example::common::write_png(&written, $scale, $displays).unwrap();
        let documented = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/images/examples");
        let is_equal = read_png(&written) == read_png(&documented.join(name));
        assert!(is_equal, "docs/images/examples/{name} is out of date");
    };
}

#[test]
fn documentation_shows_the_pictures() {
    let frames = animation::TIMES.map(|time| animation::frame(time).unwrap());
    assert_documented!(first_scene, 1, &[first_scene::picture().unwrap()]);
    assert_documented!(over_interface, 2, &[over_interface::picture().unwrap()]);
    assert_documented!(progressive, 2, &progressive::pictures().unwrap().0);
    assert_documented!(antialiased, 4, &antialiased::pictures().unwrap());
    assert_documented!(animation, 1, &frames);
}
