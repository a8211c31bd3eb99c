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
    /// A press of a button while a picture is drawn.
    DuringPicture(Button),
    /// A transfer over USB after a picture is complete.
    Usb(&'e dyn Fn(&Port) -> Result<()>),
}

/// Runs firmware, which draws a first picture and another picture after each event. Returns all
/// pictures, even interrupted ones, each with its number of cycles.
pub(super) fn run(elf: &Path, events: &[Event<'_>]) -> Result<Vec<(Picture, u64)>> {
    install()?;
    let stream = scratch_dir()?.join("pico.stream");
    let mut node = command("node");
    node.arg(root().join(FOLDER).join("run.js"))
        .args([elf, &stream]);
    node.args(events.iter().map(|event| match event {
        Event::AfterPicture(button) => format!("press:{}", *button as u8),
        Event::DuringPicture(button) => format!("amid:{}", *button as u8),
        Event::Usb(_) => "usb".to_owned(),
    }));
    node.stdin(Stdio::null()).stdout(Stdio::piped());
    let has_usb = events.iter().any(|event| matches!(event, Event::Usb(_)));
    let port = has_usb.then(Port::new).transpose()?;
    if let Some(port) = &port {
        node.stdin(port.device()?);
    }
    let mut node = node.spawn().context("cannot start node")?;
    let cycles = watch(&mut node, events, port.as_ref());
    if cycles.is_err() {
        node.kill()?;
    }
    let status = node.wait()?;
    let cycles = cycles?;
    ensure!(status.success(), "the emulator failed: {status}");
    let pictures = decode(&fs::read(stream)?)?;
    Ok(pictures.into_iter().zip(cycles).collect())
}

/// Reads the emulator's output and returns the number of cycles of each picture. Runs the USB
/// transfers between pictures.
fn watch(node: &mut Child, events: &[Event<'_>], port: Option<&Port>) -> Result<Vec<u64>> {
    let output = node.stdout.take().context("node has no output")?;
    let mut lines = BufReader::new(output).lines();
    let mut cycles = Vec::new();
    for event in events {
        cycles.push(next_cycles(&mut lines)?);
        if let (Event::Usb(transfer), Some(port)) = (event, port) {
            transfer(port)?;
        }
    }
    cycles.push(next_cycles(&mut lines)?);
    Ok(cycles)
}

/// Prints the next line, such as "cycles: 1234, bytes: 567", and returns the cycles in it.
fn next_cycles(lines: &mut Lines<impl BufRead>) -> Result<u64> {
    let line = lines
        .next()
        .context("the emulator ended before a picture")??;
    println!("{line}");
    let cycles = line
        .strip_prefix("cycles: ")
        .and_then(|rest| rest.split(',').next());
    Ok(cycles.context("the emulator printed no cycles")?.parse()?)
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
