//! A test with scenes whose lines, and even pixels, take minutes.

use anyhow::{Result, ensure};

use super::emulator::{self, Button, Event};
use super::port::Port;
use super::{firmware, transfers};
use crate::{root, scene};

/// Clock frequency of the core in hertz.
const CLOCK: f64 = 125e6;

/// Draws two slow scenes, each from two sides. Buttons, and then a scene over USB, interrupt the
/// pictures, each after a quarter of the given time on the chip. Checks that the firmware responds
/// to each of them and feeds its watchdog in time.
pub(super) fn run(seconds: f64) -> Result<()> {
    let slow =
        ["slow_lines", "slow_pixels"].map(|name| root().join(format!("tests/stress/{name}.toml")));
    let elf = firmware::build(&[&slow[0], &slow[1]])?;
    let program = transfers::build_sim()?;
    let sent = scene("still_life");
    let transfer = |port: &Port| transfers::send(&program, port, &sent);
    let cycles = (seconds / 4.0 * CLOCK) as u64;
    let events = [
        Event::DuringPicture(Button::Right, cycles),
        Event::DuringPicture(Button::Next, cycles),
        Event::DuringPicture(Button::Right, cycles),
        Event::DuringPicture(Button::Right, cycles),
        Event::UsbDuringPicture(&transfer),
        Event::Stop,
    ];
    let drawn = emulator::run(&elf, &events)?;
    ensure!(drawn.len() == events.len(), "{} pictures", drawn.len());
    drawn.iter().try_for_each(|drawn| drawn.times.check())
}
