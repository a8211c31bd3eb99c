//! Runs the firmware in rp2040js and decodes the pictures on its display.

use std::fs;
use std::io::{BufRead, BufReader, Lines};
use std::path::Path;
use std::process::{Child, Stdio};

use anyhow::{Context, Result, ensure};
use display_stream::{Byte, Controller, Picture};

use super::panel::PANEL;
use super::port::Port;
use crate::command::{command, run as run_command};
use crate::{root, scratch_dir, tools};

/// Folder of the emulator's script and npm packages.
const FOLDER: &str = "boards/pico/emulator";

/// Marks the end of a picture in the emulator's output file. This value is in the place of the
/// level of the D/C pin, which is 0 or 1.
const END: u8 = 2;

/// A button of the board. The discriminant is the number of the button's pin.
#[derive(Clone, Copy, Debug)]
pub(super) enum Button {
    Next = 15,
    Right = 20,
}

/// An event that makes the firmware draw another picture.
#[derive(Clone, Copy)]
pub(super) enum Event<'e> {
    /// A press of a button after a picture is complete.
    AfterPicture(Button),
    /// A press of a button while a picture is drawn, so many cycles after its start.
    DuringPicture(Button, u64),
    /// A transfer over USB after a picture is complete.
    Usb(Transfer<'e>),
    /// A transfer over USB while a picture is drawn.
    UsbDuringPicture(Transfer<'e>),
    /// The end of the run, at the start of a picture. This event must be the last.
    Stop,
}

/// A function that sends data to the board.
type Transfer<'e> = &'e dyn Fn(&Port) -> Result<()>;

/// A picture that the firmware drew, with measurements in cycles.
pub(super) struct Drawn {
    /// The display at the end of the picture. An event may have interrupted the picture.
    pub(super) picture: Picture,
    pub(super) times: Times,
}

/// Measurements of a picture, in cycles.
#[derive(Clone, Copy)]
pub(super) struct Times {
    /// Duration of the picture.
    pub(super) picture: u64,
    /// Time from the event before this picture to the start of the picture.
    pub(super) response: u64,
    /// Longest time for which the watchdog was not fed.
    pub(super) unfed: u64,
}

impl Times {
    /// Longest allowed time from an event to its response: half a second at 125 MHz.
    const MAX_RESPONSE: u64 = 62_500_000;
    /// Longest allowed time for which the watchdog is not fed. The watchdog resets the board after
    /// two seconds, or 250 million cycles.
    const MAX_UNFED: u64 = 62_500_000;

    /// Returns an error if the firmware responded or fed its watchdog too late.
    pub(super) fn check(&self) -> Result<()> {
        let Self {
            response, unfed, ..
        } = self;
        ensure!(
            *response <= Self::MAX_RESPONSE,
            "the firmware responded {response} cycles after an event"
        );
        ensure!(
            *unfed <= Self::MAX_UNFED,
            "the firmware did not feed its watchdog for {unfed} cycles"
        );
        Ok(())
    }
}

/// Runs firmware, which draws a first picture and another picture after each event. Returns all
/// pictures, even interrupted ones.
pub(super) fn run(elf: &Path, events: &[Event<'_>]) -> Result<Vec<Drawn>> {
    install()?;
    let stream = scratch_dir()?.join("pico.stream");
    let mut node = command("node");
    node.arg(root().join(FOLDER).join("run.js"))
        .args([elf, &stream]);
    node.args(events.iter().map(|event| match event {
        Event::AfterPicture(button) => format!("press:{}", *button as u8),
        Event::DuringPicture(button, cycles) => format!("amid:{}:{cycles}", *button as u8),
        Event::Usb(_) | Event::UsbDuringPicture(_) => "usb".to_owned(),
        Event::Stop => "stop".to_owned(),
    }));
    node.stdin(Stdio::null()).stdout(Stdio::piped());
    let is_usb = |event: &Event<'_>| matches!(event, Event::Usb(_) | Event::UsbDuringPicture(_));
    let has_usb = events.iter().any(is_usb);
    let port = has_usb.then(Port::new).transpose()?;
    if let Some(port) = &port {
        node.stdin(port.device()?);
    }
    let mut node = node.spawn().context("cannot start node")?;
    let times = watch(&mut node, events, port.as_ref());
    if times.is_err() {
        node.kill()?;
    }
    let status = node.wait()?;
    let times = times?;
    ensure!(status.success(), "the emulator failed: {status}");
    let pictures = decode(&fs::read(stream)?)?;
    let drawn = pictures.into_iter().zip(times);
    Ok(drawn
        .map(|(picture, times)| Drawn { picture, times })
        .collect())
}

/// Reads the emulator's output and returns the measurements of each picture. Runs the USB
/// transfers.
fn watch(node: &mut Child, events: &[Event<'_>], port: Option<&Port>) -> Result<Vec<Times>> {
    let output = node.stdout.take().context("node has no output")?;
    let mut lines = BufReader::new(output).lines();
    let mut times = Vec::new();
    for event in events {
        if let (Event::UsbDuringPicture(transfer), Some(port)) = (event, port) {
            transfer(port)?;
        }
        times.push(next_times(&mut lines)?);
        if let (Event::Usb(transfer), Some(port)) = (event, port) {
            transfer(port)?;
        }
    }
    if !matches!(events.last(), Some(Event::Stop)) {
        times.push(next_times(&mut lines)?);
    }
    Ok(times)
}

/// Prints the next line, such as "cycles: 1234, bytes: 567, response: 89, unfed: 10", and returns
/// the cycles in it.
fn next_times(lines: &mut Lines<impl BufRead>) -> Result<Times> {
    let line = lines
        .next()
        .context("the emulator ended before a picture")??;
    println!("{line}");
    let number = |name: &str| {
        let mut fields = line.split(", ").filter_map(|field| field.split_once(": "));
        let (_, number) = fields
            .find(|(key, _)| *key == name)
            .with_context(|| format!("the emulator printed no {name}"))?;
        anyhow::Ok(number.parse()?)
    };
    Ok(Times {
        picture: number("cycles")?,
        response: number("response")?,
        unfed: number("unfed")?,
    })
}

/// Decodes the pictures in the emulator's output file. The file consists of pairs of bytes: the
/// level of the display's D/C pin, and a byte for the display.
fn decode(stream: &[u8]) -> Result<Vec<Picture>> {
    let mut controller = Controller::new(PANEL);
    let mut pictures = Vec::new();
    let (pairs, _) = stream.as_chunks();
    for (number, [data_or_command, byte]) in pairs.iter().enumerate() {
        if *data_or_command == END {
            pictures.push(controller.picture()?);
            continue;
        }
        let byte = Byte::new(*data_or_command == 1, *byte);
        controller
            .receive(byte)
            .with_context(|| format!("byte {number} to the display"))?;
    }
    Ok(pictures)
}

/// Installs the emulator's npm packages. Does nothing if the installed packages are newer than the
/// lock file.
fn install() -> Result<()> {
    let folder = root().join(FOLDER);
    let modified = |file: &str| fs::metadata(folder.join(file)).and_then(|file| file.modified());
    let installed = modified("node_modules/.package-lock.json");
    if let (Ok(installed), Ok(locked)) = (installed, modified("package-lock.json"))
        && installed >= locked
    {
        return Ok(());
    }
    tools::install_npm()?;
    let mut npm = command("npm");
    npm.args(["ci", "--silent", "--no-audit", "--no-fund"]);
    run_command(npm.current_dir(folder))
}
