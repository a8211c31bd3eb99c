// Runs firmware of the Raspberry Pi Pico in rp2040js and records its display traffic.
//
//   node run.js FIRMWARE.elf STREAM [EVENT...]
//
// The firmware draws a picture, and another picture after each event. `press:PIN` presses
// a button when the picture is complete. `amid:PIN:CYCLES` presses a button so many cycles
// after the start of the picture. `usb` waits for a scene over USB, which may arrive while the
// picture is drawn. Standard input is then a terminal in raw mode that carries the serial data
// of the USB host. `stop`, the last event, ends the run at the start of a picture.
//
// STREAM receives two bytes for each byte on the SPI: the level of D/C, then the byte. The
// bytes 2 and 0 follow each picture, complete or aborted. Standard output receives a line
// for each picture: the cycles while the LED is on, the number of SPI bytes, the cycles from
// the last input to the start of the picture, and the longest time, in cycles, for which the
// watchdog was not fed. The cycles exclude flash cache misses and SPI wait times.

import { readFileSync, readSync, writeFileSync, writeSync } from 'node:fs';
import { ConsoleLogger, GPIOPinState, LogLevel, RP2040, USBCDC } from 'rp2040js';

// Pins, as in src/pins.rs.
const DATA_OR_COMMAND = 8;
const CHIP_SELECT = 9;
const LED = 25;
const BUTTONS = [2, 15, 16, 18, 20];

const FLASH = 0x1000_0000;
const RAM = 0x2000_0000;
// Stack pointer that the boot ROM passes to the firmware.
const STACK = 0x2004_1f00;
const NANOSECONDS_PER_CYCLE = 8;
// Number of instructions between updates of the timers.
const STRIDE = 32;
// Cycles from the end of a picture to a `press`. The firmware polls its buttons every 10 ms
// (1.25 million cycles).
const AFTER = 3e6;
// Address of the watchdog, and the offset of the register that feeds it.
const WATCHDOG = 0x40058;
const WATCHDOG_LOAD = 4;
// File descriptor of the USB serial data, and its polling interval in strides.
const SERIAL = 0;
const POLL_INTERVAL = 4000;
// Timeout for a picture, in cycles.
const TIMEOUT = 20e9;

const [firmware, streamFile, ...events] = process.argv.slice(2);
if (!streamFile) {
  throw new Error('usage: node run.js FIRMWARE.elf STREAM [EVENT...]');
}

const mcu = new RP2040();
mcu.logger = new ConsoleLogger(LogLevel.Error);
load(readFileSync(firmware));
mcu.core.PC = FLASH;
mcu.core.SP = STACK;
mcu.core.LR = 0;

// Workaround: rp2040js does not clear the Thumb bit of an exception vector, so jump tables
// in interrupt handlers fail.
const { exceptionEntry } = mcu.core;
mcu.core.exceptionEntry = function (number) {
  exceptionEntry.call(this, number);
  this.PC &= ~1;
};

const stream = [];
for (const [number, spi] of mcu.spi.entries()) {
  spi.onTransmit = (byte) => {
    if (number !== 1 || isHigh(CHIP_SELECT)) {
      throw new Error('SPI transfer while the display is not selected');
    }
    stream.push(isHigh(DATA_OR_COMMAND) ? 1 : 0, byte);
    spi.completeTransmit(0);
  };
}
// Cycle of the last feed, and the longest time between two feeds since the last report.
const feeds = { last: 0, longest: 0 };
const watchdog = mcu.peripherals[WATCHDOG];
const { writeUint32 } = watchdog;
watchdog.writeUint32 = function (offset, value) {
  if (offset === WATCHDOG_LOAD) {
    feeds.longest = Math.max(feeds.longest, mcu.core.cycles - feeds.last);
    feeds.last = mcu.core.cycles;
  }
  writeUint32.call(this, offset, value);
};
watchdog.onWatchdogTrigger = () => {
  throw new Error(`watchdog reset at ${hex(mcu.core.PC)}`);
};
// Buttons connect to ground: a high level means released.
BUTTONS.forEach((pin) => mcu.gpio[pin].setInputValue(true));

// Actions of the events, from the start of a picture to the start of the next.
const ACTIONS = {
  press(pin) {
    end();
    wait(AFTER);
    push(pin);
  },
  amid(pin, cycles) {
    wait(Number(cycles));
    push(pin);
    end();
  },
  usb: () => end(),
};

const isStopped = events.at(-1) === 'stop';
if (isStopped) {
  events.pop();
}
const exchange = connect(events.includes('usb'));
let start;
// Cycle of the last input of the user.
let lastInput = 0;
begin();
for (const event of events) {
  const [name, number, cycles] = event.split(':');
  const pin = mcu.gpio[number];
  ACTIONS[name](pin, cycles);
  begin();
  pin?.setInputValue(true);
}
if (isStopped) {
  report();
} else {
  end();
}
writeFileSync(streamFile, Buffer.from(stream));

// Runs until the LED turns on: a picture begins.
function begin() {
  runUntil(() => isHigh(LED));
  const { cycles } = mcu.core;
  start = { cycles, bytes: stream.length / 2, response: cycles - lastInput };
}

// Runs until the LED turns off: the picture is complete or aborted.
function end() {
  runUntil(() => !isHigh(LED));
  report();
}

function report() {
  const bytes = stream.length / 2 - start.bytes;
  const cycles = mcu.core.cycles - start.cycles;
  const times = `response: ${start.response}, unfed: ${feeds.longest}`;
  console.log(`cycles: ${cycles}, bytes: ${bytes}, ${times}`);
  feeds.longest = 0;
  stream.push(2, 0);
}

function push(pin) {
  pin.setInputValue(false);
  lastInput = mcu.core.cycles;
}

function wait(cycles) {
  const until = mcu.core.cycles + cycles;
  runUntil(() => mcu.core.cycles > until);
}

// Connects the USB device to an emulated host. Returns a function that exchanges data with
// standard input, if `isEnabled`.
function connect(isEnabled) {
  const usb = mcu.usbCtrl;
  const host = new USBCDC(usb);
  const completeRead = usb.onEndpointRead;
  // Pending read of the firmware. It completes as soon as data is available.
  let pending;
  usb.onEndpointRead = (endpoint, size) => {
    pending = endpoint === 0 ? pending : { endpoint, size };
  };
  if (!isEnabled) {
    return () => {};
  }
  host.onSerialData = (bytes) => writeSync(SERIAL, bytes);
  return () => {
    if (host.txFIFO.empty) {
      readSerial().forEach((byte) => host.sendSerialByte(byte));
    }
    if (pending?.endpoint === host.outEndpoint && !host.txFIFO.empty) {
      const { endpoint, size } = pending;
      pending = undefined;
      completeRead(endpoint, size);
      lastInput = mcu.core.cycles;
    }
  };
}

// Returns the bytes that are available on standard input.
function readSerial() {
  const bytes = Buffer.alloc(512);
  try {
    return bytes.subarray(0, readSync(SERIAL, bytes));
  } catch (error) {
    if (error.code === 'EAGAIN') {
      return [];
    }
    throw error;
  }
}

function runUntil(isDone) {
  const { core, clock } = mcu;
  const deadline = core.cycles + TIMEOUT;
  for (let stride = 0; !isDone(); stride++) {
    if (stride % POLL_INTERVAL === 0) {
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
      throw new Error(`timeout: the firmware hangs at ${hex(core.PC)}`);
    }
  }
}

function isHigh(pin) {
  return mcu.gpio[pin].value === GPIOPinState.High;
}

function hex(address) {
  return `0x${address.toString(16)}`;
}

// Loads the segments of a 32-bit little-endian ELF file into flash.
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
