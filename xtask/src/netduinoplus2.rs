//! An STM32F405 in QEMU, whose display is only wires.

use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::Stdio;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

use anyhow::{Context, Result, bail};
use display_stream::{Byte, Controller, Panel, Picture};

use crate::command::command;
use crate::qemu::QEMU;

/// What SPI 1 is to send.
const SPI_1_DATA: u32 = 0x4001_300C;
/// The lower half sets pins of port A, the upper half resets them.
const PORT_A_SET_RESET: u32 = 0x4002_0018;
/// The pin that tells data from commands.
const DATA_OR_COMMAND: u32 = 4;

/// Firmware that takes longer hangs.
const PATIENCE: Duration = Duration::from_secs(120);

/// Runs firmware to its end, and gives what the display then shows.
///
/// QEMU tells each write to a peripheral's register in a line, in order.
pub fn draw(elf: &Path) -> Result<Picture> {
    let mut qemu = command(QEMU);
    qemu.args(["-machine", "netduinoplus2", "-nodefaults"]);
    qemu.args(["-display", "none", "-semihosting"]);
    qemu.args(["-trace", "memory_region_ops_write"]);
    qemu.arg("-kernel").arg(elf);
    qemu.stdin(Stdio::null()).stderr(Stdio::piped());
    let mut qemu = qemu
        .spawn()
        .with_context(|| format!("{QEMU} does not start"))?;
    let trace = qemu.stderr.take().context("it was piped")?;

    let (sender, receiver) = channel();
    // In a thread, as reading has no timeout. It ends with QEMU.
    thread::spawn(move || sender.send(shown(BufReader::new(trace))));
    let picture = receiver.recv_timeout(PATIENCE);
    if matches!(picture, Err(RecvTimeoutError::Timeout)) {
        qemu.kill()?;
    }
    let status = qemu.wait()?;
    match picture {
        Ok(picture) if status.success() => picture,
        Ok(picture) => picture.and_then(|_| bail!("QEMU failed: {status}")),
        Err(error) => bail!("the firmware did not end: {error}"),
    }
}

/// What the display shows after this trace.
fn shown(trace: impl BufRead) -> Result<Picture> {
    let mut controller = Controller::new(Panel::ILI9341_320X240);
    let mut is_data = false;
    for line in trace.lines() {
        let line = line?;
        match write(&line) {
            Some((SPI_1_DATA, byte)) => controller.receive(Byte::new(is_data, byte as u8))?,
            Some((PORT_A_SET_RESET, pins)) => {
                // Set, where both are told.
                is_data = (is_data && pins & 1 << (16 + DATA_OR_COMMAND) == 0)
                    || pins & 1 << DATA_OR_COMMAND != 0;
            }
            Some(_) => {}
            None => eprintln!("{line}"),
        }
    }
    Ok(controller.picture()?)
}

/// Address and value of `memory_region_ops_write cpu 0 mr 0x5565 addr 0x40023804
/// value 0x24003010 size 4 name 'RCC'`.
fn write(line: &str) -> Option<(u32, u32)> {
    let mut words = line.split(' ').skip_while(|word| *word != "addr");
    let address = hexadecimal(words.nth(1)?)?;
    (words.next()? == "value").then_some(())?;
    Some((address, hexadecimal(words.next()?)?))
}

fn hexadecimal(word: &str) -> Option<u32> {
    u32::from_str_radix(word.strip_prefix("0x")?, 16).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn writes_are_read() {
        let line =
            "memory_region_ops_write cpu 0 mr 0x55 addr 0x4001300c value 0x2c size 1 name 'x'";
        assert_eq!(write(line), Some((SPI_1_DATA, 0x2C)));
        assert_eq!(write("qemu-system-arm: no such machine"), None);
    }
}
