//! An async task that traces a line while the display receives the one before.
//!
//! `cargo run --example async` writes `async.png`. A second task blinks an LED meanwhile.
//! In firmware, the executor and `join` come from Embassy or RTIC, the display from an async
//! driver.

mod common;

use std::cell::Cell;
use std::error::Error;
use std::future::poll_fn;
use std::pin::pin;
use std::task::{Context, Poll, Waker};

use common::Display;
use common::scene::{Buffer, SCENE, SIZE};
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::*;
use whitted::{PreparedScene, Renderer};

/// Draws the picture with two line buffers.
pub(crate) async fn draw(scene: &PreparedScene<'_>, display: &mut AsyncDisplay) {
    let mut renderer = Renderer::new(scene, SIZE);
    let mut sending = [Rgb565::BLACK; SIZE.width as usize];
    let mut tracing = sending;
    renderer.render_line(0, &mut sending);
    for y in 0..SIZE.height {
        // Past the last line, `render_line` leaves the buffer as it is.
        let trace_next = async { renderer.render_line(y + 1, &mut tracing) };
        join(display.send_line(y, &sending), trace_next).await;
        std::mem::swap(&mut sending, &mut tracing);
    }
}

/// Blinks an LED until the picture is complete. Returns how often.
async fn blink(is_complete: &Cell<bool>) -> u32 {
    let mut blinks = 0;
    while !is_complete.get() {
        blinks += 1;
        yield_now().await;
    }
    blinks
}

/// A display that is busy for a while with each line.
pub(crate) struct AsyncDisplay(pub(crate) Display);

impl AsyncDisplay {
    /// Sends a line. Other work runs between start and end of the transfer.
    async fn send_line(&mut self, y: u32, line: &[Rgb565]) {
        yield_now().await;
        self.0.show_line(y, line);
    }
}

/// Draws the picture and returns how often the LED blinked meanwhile.
pub(crate) fn picture() -> Result<(Display, u32), Box<dyn Error>> {
    let mut buffer = Buffer::new();
    let scene = buffer.prepare(&SCENE)?;
    let mut display = AsyncDisplay(Display::new(SIZE));
    let is_complete = Cell::new(false);
    let drawing = async {
        draw(&scene, &mut display).await;
        is_complete.set(true);
    };
    let ((), blinks) = block_on(join(drawing, blink(&is_complete)));
    Ok((display.0, blinks))
}

fn main() -> Result<(), Box<dyn Error>> {
    let (display, blinks) = picture()?;
    println!("the LED blinked {blinks} times");
    common::save("async.png", 2, &[display])
}

/// Lets other futures run once, as if an interrupt came later.
async fn yield_now() {
    let mut has_yielded = false;
    poll_fn(|context| {
        if std::mem::replace(&mut has_yielded, true) {
            return Poll::Ready(());
        }
        context.waker().wake_by_ref();
        Poll::Pending
    })
    .await;
}

/// Runs two futures in turns until both are complete.
async fn join<A, B>(first: impl Future<Output = A>, second: impl Future<Output = B>) -> (A, B) {
    let (mut first, mut second) = (pin!(first), pin!(second));
    let (mut a, mut b) = (None, None);
    poll_fn(|context| {
        if a.is_none() {
            a = ready_value(first.as_mut().poll(context));
        }
        if b.is_none() {
            b = ready_value(second.as_mut().poll(context));
        }
        if a.is_none() || b.is_none() {
            return Poll::Pending;
        }
        a.take().zip(b.take()).map_or(Poll::Pending, Poll::Ready)
    })
    .await
}

/// Returns the output of a future that is complete.
fn ready_value<T>(poll: Poll<T>) -> Option<T> {
    match poll {
        Poll::Ready(output) => Some(output),
        Poll::Pending => None,
    }
}

/// Runs a future to its end.
fn block_on<T>(future: impl Future<Output = T>) -> T {
    let mut future = pin!(future);
    let mut context = Context::from_waker(Waker::noop());
    loop {
        if let Poll::Ready(output) = future.as_mut().poll(&mut context) {
            return output;
        }
    }
}
