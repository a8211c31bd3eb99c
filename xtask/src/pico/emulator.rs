//! The firmware in rp2040js, and what the display shows.

use std::fmt;
use std::fs;
use std::io::{BufRead, BufReader, Lines};
use std::path::Path;
use std::process::{Child, Stdio};

use anyhow::{Context, Result, bail};
use display_stream::{Byte, Controller, Picture};

use super::PANEL;
use super::port::Port;
use crate::command::{command, run as run_command};
use crate::{root, scratch_dir, tools};

/// Where the script is, and what it needs of npm.
const FOLDER: &str = "boards/pico/emulator";

/// What the stream has in place of D/C where a picture ends.
const END: u8 = 2;

/// A button, by the number of its pin.
#[derive(Clone, Copy, Debug)]
pub(super) enum Button {
    Next = 15,
    Right = 20,
}

/// After what the firmware draws another picture.
#[derive(Clone, Copy)]
pub(super) enum Event<'e> {
    /// A button is pressed when the picture is complete.
    Press(Button),
    /// A button is pressed while the picture is drawn.
    Amid(Button),
    /// Somebody does something at the other end of the USB when the picture is complete.
    Usb(&'e dyn Fn(&Port) -> Result<()>),
}

/// What the display showed when a picture was complete, or broken off, and what
/// it took.
#[derive(Clone, Debug)]
pub(super) struct Drawn {
    pub(super) picture: Picture,
    pub(super) cost: Cost,
}

/// What a picture took.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Cost {
    pub(super) cycles: u64,
    /// To the display.
    bytes: u64,
}

impl fmt::Display for Cost {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { cycles, bytes } = self;
        write!(f, "{cycles} cycles, {bytes} bytes to the display")
    }
}

/// Runs firmware until it has drawn a picture, and one after each event.
pub(super) fn run(elf: &Path, events: &[Event<'_>]) -> Result<Vec<Drawn>> {
    install()?;
    let stream = scratch_dir()?.join("pico.stream");
    let mut node = command("node");
    node.arg(root().join(FOLDER).join("run.js"))
        .args([elf, &stream]);
    node.args(events.iter().map(|event| match event {
        Event::Press(button) => format!("press:{}", *button as u8),
        Event::Amid(button) => format!("amid:{}", *button as u8),
        Event::Usb(_) => "usb".to_owned(),
    }));
    node.stdin(Stdio::null()).stdout(Stdio::piped());
    let is_connected = events.iter().any(|event| matches!(event, Event::Usb(_)));
    let port = is_connected.then(Port::new).transpose()?;
    if let Some(port) = &port {
        node.stdin(port.device()?);
    }
    let mut node = node.spawn().context("node does not start")?;
    let costs = watch(&mut node, events, port.as_ref());
    if costs.is_err() {
        // It waits for what will not come; or it has ended, and said why.
        node.kill()?;
    }
    let status = node.wait()?;
    let costs = costs?;
    if !status.success() {
        bail!("the emulator failed: {status}");
    }
    let pictures = pictures(&fs::read(stream)?)?;
    let drawn = pictures.into_iter().zip(costs);
    Ok(drawn
        .map(|(picture, cost)| Drawn { picture, cost })
        .collect())
}

/// Does what is to be done outside of the emulator; what the pictures took.
fn watch(node: &mut Child, events: &[Event<'_>], port: Option<&Port>) -> Result<Vec<Cost>> {
    let printed = node.stdout.take().context("it was piped")?;
    let mut printed = BufReader::new(printed).lines();
    let mut costs = Vec::new();
    for event in events {
        costs.push(next(&mut printed)?);
        if let (Event::Usb(act), Some(port)) = (event, port) {
            act(port)?;
        }
    }
    costs.push(next(&mut printed)?);
    Ok(costs)
}

fn next(printed: &mut Lines<impl BufRead>) -> Result<Cost> {
    let line = printed.next().context("no picture ended")??;
    let numbers = line.strip_prefix("cycles: ").unwrap_or_default();
    let (cycles, bytes) = numbers.split_once(", bytes: ").context(line.clone())?;
    Ok(Cost {
        cycles: cycles.parse()?,
        bytes: bytes.parse()?,
    })
}

/// The pictures of a stream.
fn pictures(stream: &[u8]) -> Result<Vec<Picture>> {
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

/// Installs the emulator, once for each version.
fn install() -> Result<()> {
    let folder = root().join(FOLDER);
    let installed = folder.join("node_modules/.package-lock.json");
    let newer = |file: &Path| fs::metadata(file)?.modified();
    let is_there = match (newer(&installed), newer(&folder.join("package-lock.json"))) {
        (Ok(installed), Ok(wanted)) => installed >= wanted,
        _ => false,
    };
    if is_there {
        return Ok(());
    }
    tools::install_npm()?;
    let mut npm = command("npm");
    npm.args(["ci", "--silent", "--no-audit", "--no-fund"]);
    run_command(npm.current_dir(folder))
}
