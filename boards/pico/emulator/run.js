// Runs firmware of the Raspberry Pi Pico in rp2040js, and writes down what it
// sends to the display.
//
//   node run.js FIRMWARE.elf STREAM [EVENT...]
//
// The firmware draws a picture, and another after each event: `press:PIN` presses a
// button once the picture is complete, `amid:PIN` while it is drawn; `usb` waits for what
// comes over USB, whose host sits at standard input, a terminal in raw mode.
//
// STREAM gets two bytes for each byte that is sent: the level of D/C and the byte; after
// each picture, complete or broken off, the two bytes 2 and 0. Standard output gets for
// each picture the cycles from when the LED lights up until it goes out, and the bytes
// that are sent meanwhile. Misses of the flash's cache and the time that the SPI takes
// are not among the cycles.

import { readFileSync, readSync, writeFileSync, writeSync } from 'node:fs';
import { ConsoleLogger, GPIOPinState, LogLevel, RP2040, USBCDC } from 'rp2040js';

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
// In the middle of a picture, and after it: so many cycles later. The firmware looks
// at its buttons each 10 ms.
const AMID = 20e6;
const AFTER = 3e6;
// Where somebody uses the USB's host, who is asked for bytes each so many strides.
const HOST = 0;
const QUIET = 4000;
// Firmware that takes longer for a picture hangs.
const PATIENCE = 20e9;

const [firmware, streamFile, ...events] = process.argv.slice(2);
if (!streamFile) {
  throw new Error('node run.js FIRMWARE.elf STREAM [EVENT...]');
}

const mcu = new RP2040();
mcu.logger = new ConsoleLogger(LogLevel.Error);
load(readFileSync(firmware));
mcu.core.PC = FLASH;
mcu.core.SP = STACK;
mcu.core.LR = 0;

// The emulator forgets to clear the bit of an exception's vector that says Thumb;
// then no jump table works.
const { exceptionEntry } = mcu.core;
mcu.core.exceptionEntry = function (number) {
  exceptionEntry.call(this, number);
  this.PC &= ~1;
};

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

// What each event does while a picture is drawn, until the next begins.
const HAPPEN = {
  press(pin) {
    end();
    wait(AFTER);
    pin.setInputValue(false);
  },
  amid(pin) {
    wait(AMID);
    pin.setInputValue(false);
    end();
  },
  usb: () => end(),
};

const exchange = connect(events.includes('usb'));
let start;
begin();
for (const event of events) {
  const [what, number] = event.split(':');
  const pin = mcu.gpio[number];
  HAPPEN[what](pin);
  begin();
  pin?.setInputValue(true);
}
end();
writeFileSync(streamFile, Buffer.from(stream));

// Runs until a picture begins.
function begin() {
  runUntil(() => isHigh(LED));
  start = { cycles: mcu.core.cycles, bytes: stream.length / 2 };
}

// Runs until it is complete, or broken off.
function end() {
  runUntil(() => !isHigh(LED));
  const bytes = stream.length / 2 - start.bytes;
  console.log(`cycles: ${mcu.core.cycles - start.cycles}, bytes: ${bytes}`);
  stream.push(2, 0);
}

function wait(cycles) {
  const until = mcu.core.cycles + cycles;
  runUntil(() => mcu.core.cycles > until);
}

// Connects the USB to a host. Returns a function that takes what the host
// sends, if there is somebody.
function connect(isSomebodyThere) {
  const usb = mcu.usbCtrl;
  const host = new USBCDC(usb);
  const answer = usb.onEndpointRead;
  // Where the firmware wants data: it gets them as soon as there are some.
  let wanted;
  usb.onEndpointRead = (endpoint, size) => {
    wanted = endpoint === 0 ? wanted : { endpoint, size };
  };
  if (!isSomebodyThere) {
    return () => {};
  }
  host.onSerialData = (bytes) => writeSync(HOST, bytes);
  return () => {
    if (host.txFIFO.empty) {
      received().forEach((byte) => host.sendSerialByte(byte));
    }
    if (wanted?.endpoint === host.outEndpoint && !host.txFIFO.empty) {
      const { endpoint, size } = wanted;
      wanted = undefined;
      answer(endpoint, size);
    }
  };
}

// What somebody sent to the host, if anything.
function received() {
  const bytes = Buffer.alloc(512);
  try {
    return bytes.subarray(0, readSync(HOST, bytes));
  } catch (error) {
    if (error.code === 'EAGAIN') {
      return [];
    }
    throw error;
  }
}

function runUntil(isDone) {
  const { core, clock } = mcu;
  const deadline = core.cycles + PATIENCE;
  for (let stride = 0; !isDone(); stride++) {
    if (stride % QUIET === 0) {
      exchange();
    }
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
