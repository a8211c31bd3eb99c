// Runs firmware of the Raspberry Pi Pico in rp2040js, and writes down what it
// sends to the display.
//
//   node run.js FIRMWARE.elf STREAM [BUTTON...]
//
// The firmware draws a picture, and another after each button, which is named by the
// number of its pin. STREAM gets two bytes for each byte that is sent: the level of D/C and
// the byte; after each picture the two bytes 2 and 0. Standard output gets the
// cycles of each picture, from when the LED lights up until it goes out. Misses of
// the flash's cache and the time that the SPI takes are not among them.

import { readFileSync, writeFileSync } from 'node:fs';
import { ConsoleLogger, GPIOPinState, LogLevel, RP2040 } from 'rp2040js';

// The pins of src/pins.rs.
const DATA_OR_COMMAND = 8;
const CHIP_SELECT = 9;
const LED = 25;
const BUTTONS = [2, 15, 16, 18, 20];

const FLASH = 0x1000_0000;
const RAM = 0x2000_0000;
// Where the boot ROM leaves the stack, and how it ends it.
const STACK = 0x2004_1f00;
const NANOSECONDS_PER_CYCLE = 8;
// Time goes on by so many instructions at once.
const STRIDE = 32;
// Firmware that takes longer for a picture hangs.
const PATIENCE = 20e9;

const [firmware, streamFile, ...buttons] = process.argv.slice(2);
if (!streamFile) {
  throw new Error('node run.js FIRMWARE.elf STREAM [BUTTON...]');
}

const mcu = new RP2040();
mcu.logger = new ConsoleLogger(LogLevel.Error);
load(readFileSync(firmware));
mcu.core.PC = FLASH;
mcu.core.SP = STACK;
mcu.core.LR = 0;

const stream = [];
for (const [number, spi] of mcu.spi.entries()) {
  spi.onTransmit = (byte) => {
    if (number !== 1 || isHigh(CHIP_SELECT)) {
      throw new Error('a byte is sent while the display is not selected');
    }
    stream.push(isHigh(DATA_OR_COMMAND) ? 1 : 0, byte);
    spi.completeTransmit(0);
  };
}
mcu.peripherals[0x40058].onWatchdogTrigger = () => {
  throw new Error(`the watchdog restarts the board, at ${hex(mcu.core.PC)}`);
};
// Nothing is pressed.
BUTTONS.forEach((pin) => mcu.gpio[pin].setInputValue(true));

picture();
for (const button of buttons) {
  const pin = mcu.gpio[Number(button)];
  pin.setInputValue(false);
  picture(() => pin.setInputValue(true));
}
writeFileSync(streamFile, Buffer.from(stream));

// Runs until a picture is complete.
function picture(started = () => {}) {
  runUntil(() => isHigh(LED));
  const start = mcu.core.cycles;
  started();
  runUntil(() => !isHigh(LED));
  stream.push(2, 0);
  console.log(`cycles: ${mcu.core.cycles - start}`);
}

function runUntil(isDone) {
  const { core, clock } = mcu;
  const deadline = core.cycles + PATIENCE;
  while (!isDone()) {
    const before = core.cycles;
    for (let i = 0; i < STRIDE; i++) {
      core.executeInstruction();
    }
    clock.tick((core.cycles - before) * NANOSECONDS_PER_CYCLE);
    const isInFlash = core.PC >= FLASH && core.PC < FLASH + mcu.flash.length;
    const isInRam = core.PC >= RAM && core.PC < RAM + mcu.sram.length;
    if (!isInFlash && !isInRam) {
      throw new Error(`the firmware jumps to ${hex(core.PC)}`);
    }
    if (core.cycles > deadline) {
      throw new Error(`the firmware hangs at ${hex(core.PC)}`);
    }
  }
}

function isHigh(pin) {
  return mcu.gpio[pin].value === GPIOPinState.High;
}

function hex(address) {
  return `0x${address.toString(16)}`;
}

// Puts the segments of an ELF file (32 bits, little-endian) into flash.
function load(elf) {
  const [start, size, count] = [elf.readUInt32LE(28), elf.readUInt16LE(42), elf.readUInt16LE(44)];
  for (let header = start; header < start + size * count; header += size) {
    const [type, from, , address, length] = [0, 4, 8, 12, 16].map((field) => elf.readUInt32LE(header + field));
    const isLoaded = type === 1 && length > 0;
    if (isLoaded) {
      mcu.flash.set(elf.subarray(from, from + length), address - FLASH);
    }
  }
}
