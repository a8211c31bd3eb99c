//! A picture in coarse blocks first, drawn in short steps between other work.
//!
//! `cargo run --example progressive` writes `progressive.png`: the picture after the first
//! pass, at the press of a button, and at the end.

pub(crate) mod common;

use std::convert::Infallible;
use std::error::Error;

use common::Display;
use common::scene::{Buffer, SCENE, SIZE};
use embedded_graphics::prelude::*;
use whitted::Renderer;
use whitted::render::{DisplayColor, RenderProgress, Step};

/// Draws until the picture is complete or a button is pressed.
///
/// Another call with `progress` continues the picture. `progress` is 14 bytes of plain data.
pub(crate) fn draw<D>(
    renderer: &mut Renderer<'_>,
    progress: &mut RenderProgress,
    display: &mut D,
    watchdog: &mut Watchdog,
    button: &mut Button,
) -> Result<(), D::Error>
where
    D: DrawTarget<Color: DisplayColor>,
{
    while !progress.is_complete() && !button.is_pressed() {
        // 800 rays take about 10 ms on a Cortex-M0+ at 133 MHz.
        renderer.step(progress, Step::Rays(800), display)?;
        watchdog.feed();
    }
    Ok(())
}

/// Stands for the watchdog timer of a microcontroller.
#[derive(Debug, Default)]
pub(crate) struct Watchdog {
    pub(crate) feeds: u32,
}

impl Watchdog {
    fn feed(&mut self) {
        self.feeds += 1;
    }
}

/// Stands for a button that the user presses after a number of steps.
#[derive(Debug)]
pub(crate) struct Button {
    pub(crate) steps_until_pressed: u32,
}

impl Button {
    fn is_pressed(&mut self) -> bool {
        let is_pressed = self.steps_until_pressed == 0;
        self.steps_until_pressed = self.steps_until_pressed.saturating_sub(1);
        is_pressed
    }
}

/// Returns the display after the first pass, when the button is pressed, and at the end.
pub(crate) fn pictures(watchdog: &mut Watchdog) -> Result<[Display; 3], Box<dyn Error>> {
    let mut buffer = Buffer::new();
    let scene = buffer.prepare(&SCENE)?;
    let mut renderer = Renderer::new(&scene, SIZE);
    let mut display = Display::new(SIZE);
    let mut progress = RenderProgress::progressive(display.bounding_box());

    // The first pass draws blocks of 16 by 16 pixels: 1/256 of the work.
    renderer.step(&mut progress, Step::Pass, &mut display)?;
    let after_first_pass = display.clone();

    let mut continue_until = |steps_until_pressed| -> Result<Display, Infallible> {
        let mut button = Button {
            steps_until_pressed,
        };
        draw(
            &mut renderer,
            &mut progress,
            &mut display,
            watchdog,
            &mut button,
        )?;
        Ok(display.clone())
    };
    // The firmware now does what the button asks for, and later completes the picture.
    let at_press = continue_until(3)?;
    let at_end = continue_until(u32::MAX)?;
    Ok([after_first_pass, at_press, at_end])
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut watchdog = Watchdog::default();
    let pictures = pictures(&mut watchdog)?;
    println!("fed the watchdog {} times", watchdog.feeds);
    common::save("progressive.png", 2, &pictures)
}
