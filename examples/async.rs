//! An async task traces a line while the display receives the previous line.
//!
//! `cargo run --example async` writes `async.png`. A second task blinks an LED while the
//! picture is drawn.

pub(crate) mod common;

use std::cell::Cell;
use std::error::Error;

use common::Display;
use common::scene::{Buffer, SCENE, SIZE};
use embassy_futures::join::join;
use embassy_futures::{block_on, yield_now};
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::*;
use whitted::{PreparedScene, Renderer};

/// Draws the picture with two line buffers: one is sent while the other is traced.
async fn draw(scene: &PreparedScene<'_>, display: &mut AsyncDisplay) {
    let mut renderer = Renderer::new(scene, SIZE);
    let mut sent = [Rgb565::BLACK; SIZE.width as usize];
    let mut traced = sent;
    renderer.render_line(0, &mut sent);
    for y in 0..SIZE.height {
        // `join` polls the transfer first, so the bus is busy while the next line is traced.
        // After the last line there is no next line, and `render_line` does nothing.
        let trace_next = async { renderer.render_line(y + 1, &mut traced) };
        join(display.send_line(y, &sent), trace_next).await;
        core::mem::swap(&mut sent, &mut traced);
    }
}

/// Blinks an LED until the picture is complete, and returns the number of blinks.
///
/// Tracing a line contains no `.await`, so this task never waits for more than one line.
async fn blink(is_complete: &Cell<bool>) -> u32 {
    let mut blinks = 0;
    while !is_complete.get() {
        blinks += 1;
        yield_now().await;
    }
    blinks
}

/// Stands for an async display driver. A real driver learns from an interrupt that a transfer
/// has ended.
struct AsyncDisplay(Display);

impl AsyncDisplay {
    /// Sends a line. Other tasks run until the transfer ends.
    async fn send_line(&mut self, y: u32, line: &[Rgb565]) {
        yield_now().await;
        self.0.show_line(y, line);
    }
}

/// Draws the picture. Also returns how often the LED blinked during the drawing.
pub(crate) fn picture() -> Result<(Display, u32), Box<dyn Error>> {
    let mut buffer = Buffer::new();
    let scene = buffer.prepare(&SCENE)?;
    let mut display = AsyncDisplay(Display::new(SIZE));
    let is_complete = Cell::new(false);
    let drawing = async {
        draw(&scene, &mut display).await;
        is_complete.set(true);
    };
    // In firmware, each of the two tasks would be a `#[embassy_executor::task]`.
    let ((), blinks) = block_on(join(drawing, blink(&is_complete)));
    Ok((display.0, blinks))
}

fn main() -> Result<(), Box<dyn Error>> {
    let (display, blinks) = picture()?;
    println!("the LED blinked {blinks} times");
    common::save("async.png", 2, &[display])
}
