//! Runs firmware on an STM32F405 in QEMU. QEMU has no display for this board, so the picture is
//! reconstructed from the writes to SPI and GPIO registers.

use std::path::Path;

use anyhow::Result;
use display_stream::{Byte, Controller, Panel, Picture};

use crate::command::command;
use crate::qemu::{QEMU, Running};

/// Data register of SPI 1.
const SPI_1_DATA: u32 = 0x4001_300C;
/// Bit set/reset register of port A. The lower 16 bits set pins. The upper 16 bits reset pins.
const PORT_A_SET_RESET: u32 = 0x4002_0018;
/// Number of the D/C pin in port A. It is high for display data and low for display commands.
const DATA_OR_COMMAND: u32 = 4;

/// Runs firmware until it exits. Returns the picture on the display.
pub fn draw(elf: &Path) -> Result<Picture> {
    let mut qemu = command(QEMU);
    qemu.args(["-machine", "netduinoplus2", "-nodefaults"]);
    qemu.args(["-display", "none", "-semihosting"]);
    // With these options, QEMU prints a line for each write to a peripheral register.
    qemu.args(["-trace", "memory_region_ops_write", "-D", "/dev/stdout"]);
    qemu.arg("-kernel").arg(elf);
    let trace = Running::start(qemu)?.finish()?;

    let mut controller = Controller::new(Panel::ILI9341_320X240);
    let mut is_data = false;
    for write in trace.lines().iter().filter_map(|line| register_write(line)) {
        match write {
            (SPI_1_DATA, byte) => controller.receive(Byte::new(is_data, byte as u8))?,
            (PORT_A_SET_RESET, pins) => {
                let is_reset = pins & 1 << (16 + DATA_OR_COMMAND) != 0;
                let is_set = pins & 1 << DATA_OR_COMMAND != 0;
                is_data = is_set || is_data && !is_reset;
            }
            _ => {}
        }
    }
    Ok(controller.picture()?)
}

/// Returns the address and the value of a register write in QEMU's trace, such as
/// `memory_region_ops_write cpu 0 mr 0x5565 addr 0x40023804 value 0x24003010 size 4 name 'RCC'`.
fn register_write(line: &str) -> Option<(u32, u32)> {
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
    fn reads_register_writes() {
        let line = "memory_region_ops_write cpu 0 mr 0x55 addr 0x4001300c value 0x2c size 1";
        assert_eq!(register_write(line), Some((SPI_1_DATA, 0x2C)));
        assert_eq!(register_write("qemu-system-arm: no such machine"), None);
    }
}
