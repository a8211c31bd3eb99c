//! Two cores draw one picture. They share a prepared scene, and each core traces every other
//! line.
//!
//! `cargo run --release --example two_renderers` writes `two_renderers.png`. The example also
//! prints how long one thread takes for the picture, and how long two threads take.

pub(crate) mod common;

use std::error::Error;
use std::thread;
use std::time::Instant;

use common::Display;
use common::scene::{Buffer, SCENE, SIZE};
use embedded_graphics::pixelcolor::Rgb565;
use whitted::{PreparedScene, Renderer};

/// Traces lines `first`, `first + 2`, `first + 4` and so on, each into its slice of `lines`.
///
/// Each core has its own `Renderer`, which takes 0.7 KB. In firmware, each core would also
/// have its own line buffer, and only one core at a time would use the display.
fn trace_every_other(scene: &PreparedScene<'_>, first: u32, lines: Vec<&mut [Rgb565]>) {
    let mut renderer = Renderer::new(scene, SIZE);
    for (y, line) in (first..).step_by(2).zip(lines) {
        renderer.render_line(y, line);
    }
}

/// Draws the picture with two threads.
pub(crate) fn draw_with_two(scene: &PreparedScene<'_>) -> Display {
    let mut display = Display::new(SIZE);
    let (mut even, mut odd) = (Vec::new(), Vec::new());
    for pair in display.pixels.chunks_mut(2 * SIZE.width as usize) {
        let (first, second) = pair.split_at_mut(SIZE.width as usize);
        even.push(first);
        odd.push(second);
    }
    // Both threads borrow the prepared scene. They can share the scene because the renderer
    // never changes it.
    thread::scope(|scope| {
        scope.spawn(|| trace_every_other(scene, 0, even));
        trace_every_other(scene, 1, odd);
    });
    display
}

/// Draws the picture with one thread.
pub(crate) fn draw_with_one(scene: &PreparedScene<'_>) -> Display {
    let mut display = Display::new(SIZE);
    let Ok(()) = Renderer::new(scene, SIZE).draw(&mut display);
    display
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut buffer = Buffer::new();
    let scene = buffer.prepare(&SCENE)?;
    let start = Instant::now();
    draw_with_one(&scene);
    println!("one thread: {:.1?}", start.elapsed());
    let start = Instant::now();
    let display = draw_with_two(&scene);
    println!("two threads: {:.1?}", start.elapsed());
    common::save("two_renderers.png", 2, &[display])
}
