//! Draws with two line buffers. While DMA sends the line in one buffer, the next line is
//! traced into the other buffer.
//!
//! `cargo run --example dma_lines` writes `dma_lines.png`.

pub(crate) mod common;

use std::error::Error;
use std::thread::{self, JoinHandle};

use common::Display;
use common::scene::{Buffer, SCENE, SIZE};
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::*;
use whitted::{PreparedScene, Renderer};

/// A line of 160 pixels, which takes 320 bytes. Firmware would use a
/// `&'static mut [Rgb565; 160]`.
type Line = Box<[Rgb565; SIZE.width as usize]>;

/// Draws the picture with two line buffers. The initial contents of the buffers do not matter.
pub(crate) fn draw(scene: &PreparedScene<'_>, display: Display, lines: [Line; 2]) -> Display {
    let [mut first, mut free] = lines;
    let mut renderer = Renderer::new(scene, SIZE);
    renderer.render_line(0, first.as_mut_slice());
    let mut transfer = Transfer::start(display, 0, first);
    for y in 1..SIZE.height {
        // The renderer traces into the free buffer while the DMA sends the other buffer.
        renderer.render_line(y, free.as_mut_slice());
        let (display, sent) = transfer.wait();
        transfer = Transfer::start(display, y, free);
        free = sent;
    }
    transfer.wait().0
}

/// A DMA transfer, simulated by a thread.
///
/// As in embedded HALs, a transfer owns the display and the line buffer until the transfer
/// ends. The compiler therefore rejects code that writes to a line during its transfer.
struct Transfer(JoinHandle<(Display, Line)>);

impl Transfer {
    /// Starts sending line `y`.
    fn start(mut display: Display, y: u32, line: Line) -> Self {
        Self(thread::spawn(move || {
            display.show_line(y, line.as_slice());
            (display, line)
        }))
    }

    /// Waits until the transfer ends.
    fn wait(self) -> (Display, Line) {
        match self.0.join() {
            Ok(display_and_line) => display_and_line,
            Err(panic) => std::panic::resume_unwind(panic),
        }
    }
}

/// Draws the picture on a display that is black at first.
pub(crate) fn picture() -> Result<Display, Box<dyn Error>> {
    let mut buffer = Buffer::new();
    let scene = buffer.prepare(&SCENE)?;
    let line = || Line::new([Rgb565::BLACK; SIZE.width as usize]);
    Ok(draw(&scene, Display::new(SIZE), [line(), line()]))
}

fn main() -> Result<(), Box<dyn Error>> {
    common::save("dma_lines.png", 2, &[picture()?])
}
