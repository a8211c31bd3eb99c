//! Draws a picture in coarse blocks first and then refines it. The drawing is divided into
//! short steps, so the program can do other work between two steps.
//!
//! `cargo run --example progressive` writes `progressive.png`, which shows the picture at
//! three times: after the first pass, when a button is pressed, and at the end.

pub(crate) mod common;

use std::error::Error;

use common::Display;
use common::scene::{Buffer, SCENE, SIZE};
use embedded_graphics::prelude::*;
use whitted::Renderer;
use whitted::render::{DisplayColor, RenderProgress, Step};

/// Draws until the picture is complete or a button is pressed.
///
/// To continue the picture, call `draw` again with the same `progress`. This value takes 14
/// bytes.
pub(crate) fn draw<D>(
    renderer: &mut Renderer<'_>,
    progress: &mut RenderProgress,
    display: &mut D,
    board: &mut Board,
) -> Result<(), D::Error>
where
    D: DrawTarget<Color: DisplayColor>,
{
    while !progress.is_complete() && !board.is_button_pressed() {
        // A step of 800 rays takes about 10 ms on a Cortex-M0+ at 133 MHz.
        renderer.step(progress, Step::Rays(800), display)?;
        board.feed_watchdog();
    }
    Ok(())
}

/// Simulates the watchdog and the button of a microcontroller board.
#[derive(Debug)]
pub(crate) struct Board {
    watchdog_feeds: u32,
    steps_until_pressed: u32,
}

impl Board {
    fn feed_watchdog(&mut self) {
        self.watchdog_feeds += 1;
    }

    fn is_button_pressed(&mut self) -> bool {
        let is_pressed = self.steps_until_pressed == 0;
        self.steps_until_pressed = self.steps_until_pressed.saturating_sub(1);
        is_pressed
    }
}

/// Returns copies of the display after the first pass, when the button is pressed, and at the
/// end.
///
/// Also returns how often the watchdog was fed.
pub(crate) fn pictures() -> Result<([Display; 3], u32), Box<dyn Error>> {
    let mut buffer = Buffer::new();
    let scene = buffer.prepare(&SCENE)?;
    let mut renderer = Renderer::new(&scene, SIZE);
    let mut display = Display::new(SIZE);
    let mut progress = RenderProgress::progressive(display.bounding_box());
    let mut board = Board {
        watchdog_feeds: 0,
        steps_until_pressed: 3,
    };

    // The first pass traces one pixel for each block of 16 by 16 pixels, so it does 1/256 of
    // the work.
    renderer.step(&mut progress, Step::Pass, &mut display)?;
    let first_pass = display.clone();

    draw(&mut renderer, &mut progress, &mut display, &mut board)?;
    let at_press = display.clone();

    // At this point, firmware would react to the button. This example completes the picture.
    board.steps_until_pressed = u32::MAX;
    draw(&mut renderer, &mut progress, &mut display, &mut board)?;
    Ok(([first_pass, at_press, display], board.watchdog_feeds))
}

fn main() -> Result<(), Box<dyn Error>> {
    let (pictures, watchdog_feeds) = pictures()?;
    println!("fed the watchdog {watchdog_feeds} times");
    common::save("progressive.png", 2, &pictures)
}
