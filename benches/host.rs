//! `cargo bench` compares the speed of the library on the host with the speed of the `f32`
//! reference tracer.
//!
//! Both tracers draw the same RGB565 frames, line by line, on one thread. The scenes are
//! prepared before the measurement starts. The rig `tests/rigs/float` uses the same
//! reference tracer. No test depends on the measured times.

use std::error::Error;
use std::hint::black_box;
use std::path::Path;
use std::time::Instant;

use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::*;
use whitted::Renderer;
use whitted_sim::scene_file;

/// Names of the scenes, each with the size of its frame. The frame of `sphereflake` is
/// small, because the `f32` tracer would need about a second for 320x240 pixels.
const FRAMES: [(&str, Size); 3] = [
    ("whitted", Size::new(320, 240)),
    ("four_spheres", Size::new(320, 240)),
    ("sphereflake", Size::new(80, 60)),
];

/// Number of frames that each tracer draws. The median frame counts.
const ROUNDS: usize = 31;

fn main() -> Result<(), Box<dyn Error>> {
    for (name, size) in FRAMES {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/scenes/{name}.toml"));
        let scene_file = scene_file::load(&file)?;
        let mut buffer = Box::new(scene_file::Buffer::new());
        let scene = scene_file.prepare(&mut buffer)?;
        let mut fixed = fixed(Renderer::new(&scene, size));
        let scene = whitted_oracle::load::<f32>(&file);
        let mut float = float(scene.scene(), size);

        let [fixed, float] = frame_times(&mut fixed, &mut float);
        println!(
            "{name} {}x{}: fixed point {:.2} ms, f32 {:.2} ms, ratio {:.2}",
            size.width,
            size.height,
            1e3 * fixed,
            1e3 * float,
            float / fixed
        );
    }
    Ok(())
}

/// Returns a function that draws one frame with the library.
fn fixed(mut renderer: Renderer<'_>) -> impl FnMut() {
    let Size { width, height } = renderer.size();
    let mut line = vec![Rgb565::BLACK; width as usize];
    move || {
        for y in 0..height {
            renderer.render_line(y, &mut line);
            black_box(&mut line);
        }
    }
}

/// Returns a function that draws one frame with the reference tracer.
fn float(scene: whitted_oracle::Scene<'_, f32>, size: Size) -> impl FnMut() {
    let Size { width, height } = size;
    let view = scene.camera.view(width, height);
    let mut line = vec![Rgb565::BLACK; width as usize];
    move || {
        for y in 0..height {
            for (x, pixel) in (0..).zip(&mut line) {
                *pixel = to_rgb565(scene.pixel(&view, x, y));
            }
            black_box(&mut line);
        }
    }
}

/// Clamps each channel of a color to 0..=1 and rounds it to the nearest RGB565 level.
fn to_rgb565(color: whitted_oracle::Color<f32>) -> Rgb565 {
    let level = |value: f32, max: u8| ((value * f32::from(max) + 0.5) as u32).min(max.into()) as u8;
    Rgb565::new(
        level(color.x, Rgb565::MAX_R),
        level(color.y, Rgb565::MAX_G),
        level(color.z, Rgb565::MAX_B),
    )
}

/// Returns the median time in seconds that each of two tracers takes for a frame.
///
/// The two tracers draw frames in turn, so that other load on the machine slows down both
/// tracers.
fn frame_times(first: &mut impl FnMut(), second: &mut impl FnMut()) -> [f64; 2] {
    let mut times = [(); 2].map(|()| Vec::with_capacity(ROUNDS));
    for _ in 0..ROUNDS {
        times[0].push(seconds(first));
        times[1].push(seconds(second));
    }
    times.map(|mut times| {
        times.sort_by(f64::total_cmp);
        times[ROUNDS / 2]
    })
}

/// Returns the time to draw one frame, in seconds.
fn seconds(frame: &mut impl FnMut()) -> f64 {
    let start = Instant::now();
    frame();
    start.elapsed().as_secs_f64()
}
