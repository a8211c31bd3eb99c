//! A test that runs the firmware once, presses all buttons, and sends scenes over USB.

use std::fs;

use anyhow::{Context, Result, ensure};
use whitted_sim::scene_file;

use super::emulator::{self, Button, Drawn, Event};
use super::port::Port;
use super::{firmware, panel, transfers};
use crate::budget::Counts;
use crate::{host, scene, scratch_dir};

/// Number of cycles after which the emulator interrupts a picture by pressing a button.
const PRESS: u64 = 20_000_000;

/// Largest allowed number of cycles of an interrupted picture.
const INTERRUPTED: u64 = 30_000_000;

/// Runs the test and compares all complete pictures with the host's pictures. Returns the number of
/// cycles of each picture that has a budget.
pub(super) fn run() -> Result<Counts> {
    let (first, last) = (scene("four_spheres"), scene("bouncing_ball"));
    let sent = scene("still_life");
    let mut bytes = scene_file::compile(&first)?;
    bytes[40] ^= 1;
    let damaged = scratch_dir()?.join("damaged-on-the-pico.bin");
    fs::write(&damaged, &bytes)?;
    let elf = firmware::build(&[&first, &damaged, &last])?;
    firmware::print_size(&elf)?;

    let program = transfers::build_sim()?;
    let transfer = |port: &Port| {
        transfers::send_invalid(port, &sent)?;
        transfers::send(&program, port, &sent)
    };
    let events = [
        Event::AfterPicture(Button::Next),
        Event::AfterPicture(Button::Next),
        Event::DuringPicture(Button::Right, PRESS),
        Event::Usb(&transfer),
        Event::DuringPicture(Button::Next, PRESS),
        Event::DuringPicture(Button::Next, PRESS),
        Event::AfterPicture(Button::Next),
        Event::DuringPicture(Button::Next, PRESS),
    ];
    let error = host::decode_error(&bytes)?;
    let error = || panel::message(&format!("This scene cannot be drawn: {error}."));
    // Each entry has a name, the expected picture, and true if the picture has a budget. The
    // picture is `None` if a button interrupts it. The firmware shows the scenes in flash first,
    // then the scene from USB.
    let expected = [
        ("four_spheres", Some(panel::draw_on_host(&first)?), true),
        ("an error", Some(error()?), false),
        ("bouncing_ball", None, false),
        (
            "from the right",
            Some(panel::draw_from_the_right(&last)?),
            true,
        ),
        ("sent", None, false),
        ("four_spheres again", None, false),
        ("an error again", Some(error()?), false),
        ("bouncing_ball again", None, false),
        ("still_life", Some(panel::draw_on_host(&sent)?), true),
    ];
    let drawn = emulator::run(&elf, &events)?;
    ensure!(drawn.len() == expected.len(), "{} pictures", drawn.len());
    let mut counts = Counts::new();
    for (drawn, (name, expected, has_budget)) in drawn.into_iter().zip(expected) {
        let Drawn { picture, times } = drawn;
        let cycles = times.picture;
        times.check().context(name)?;
        match expected {
            Some(expected) => panel::compare(&picture, &expected).context(name)?,
            None => ensure!(cycles <= INTERRUPTED, "{name} took {cycles} cycles"),
        }
        if has_budget {
            counts.insert(name.to_owned(), cycles);
        }
    }
    Ok(counts)
}
