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

/// Draws the picture with two line buffers. While one buffer is sent to the display, the next
/// line is traced into the other buffer.
async fn draw(scene: &PreparedScene<'_>, display: &mut AsyncDisplay) {
    let mut renderer = Renderer::new(scene, SIZE);
    let mut sent = [Rgb565::BLACK; SIZE.width as usize];
    let mut traced = sent;
    renderer.render_line(0, &mut sent);
    for y in 0..SIZE.height {
        // `join` polls the transfer first. The transfer therefore starts before the next line
        // is traced. After the last line, `render_line` does nothing.
        let trace_next = async { renderer.render_line(y + 1, &mut traced) };
        join(display.send_line(y, &sent), trace_next).await;
        core::mem::swap(&mut sent, &mut traced);
    }
}

/// Blinks an LED until the picture is complete, and returns the number of blinks.
///
/// The code that traces a line has no `.await`, so this task cannot run until the line is
/// complete. It waits for one line at most.
async fn blink(is_complete: &Cell<bool>) -> u32 {
    let mut blinks = 0;
    while !is_complete.get() {
        blinks += 1;
        yield_now().await;
    }
    blinks
}

/// Simulates an async display driver. In a real driver, an interrupt reports the end of a
/// transfer.
struct AsyncDisplay(Display);

impl AsyncDisplay {
    /// Sends a line. Other tasks run until the transfer ends.
    async fn send_line(&mut self, y: u32, line: &[Rgb565]) {
        yield_now().await;
        self.0.show_line(y, line);
    }
}

/// Draws the picture. Returns the display and the number of times that the LED blinked.
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
