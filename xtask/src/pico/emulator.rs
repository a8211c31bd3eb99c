//! The firmware in rp2040js, and what the display shows.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result, bail};
use display_stream::{Byte, Controller, Picture};

use super::PANEL;
use crate::command::{command, run as run_command};
use crate::{root, scratch_dir, tools};

/// Where the script is, and what it needs of npm.
const FOLDER: &str = "boards/pico/emulator";

/// What the stream has in place of D/C where a picture is complete.
const COMPLETE: u8 = 2;

/// A button, by the number of its pin.
#[derive(Clone, Copy, Debug)]
pub(super) enum Button {
    Next = 15,
    Right = 20,
}

/// What the display showed when a picture was complete, and what it took.
#[derive(Clone, Debug)]
pub(super) struct Drawn {
    pub(super) picture: Picture,
    pub(super) cycles: u64,
}

/// Runs firmware until it has drawn a picture, and one after each button.
pub(super) fn run(elf: &Path, buttons: &[Button]) -> Result<Vec<Drawn>> {
    install()?;
    let stream = scratch_dir()?.join("pico.stream");
    let mut node = command("node");
    node.arg(root().join(FOLDER).join("run.js"))
        .args([elf, &stream]);
    node.args(buttons.iter().map(|button| (*button as u8).to_string()));
    let output = node.output().context("node does not start")?;
    let (printed, errors) = (
        String::from_utf8(output.stdout)?,
        String::from_utf8_lossy(&output.stderr),
    );
    if !output.status.success() {
        bail!("the emulator failed:\n{errors}");
    }
    let cycles = printed
        .lines()
        .filter_map(|line| line.strip_prefix("cycles: "));
    let pictures = pictures(&fs::read(stream)?)?;
    pictures
        .into_iter()
        .zip(cycles)
        .map(|(picture, cycles)| {
            Ok(Drawn {
                picture,
                cycles: cycles.parse()?,
            })
        })
        .collect()
}

/// The pictures that were complete in a stream.
fn pictures(stream: &[u8]) -> Result<Vec<Picture>> {
    let mut controller = Controller::new(PANEL);
    let mut pictures = Vec::new();
    let (pairs, _) = stream.as_chunks();
    for (number, [data_or_command, byte]) in pairs.iter().enumerate() {
        if *data_or_command == COMPLETE {
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
