//! Tests the controller model with hand-written byte streams.

#![allow(clippy::unwrap_used)]

use display_stream::{BlankError, Byte, Controller, Panel, StreamError};
use embedded_graphics_core::geometry::{Point, Size};
use embedded_graphics_core::pixelcolor::{IntoStorage, Rgb565, RgbColor};
use embedded_graphics_core::primitives::Rectangle;

const SMALL: Panel = Panel {
    memory: Size::new(4, 3),
    glass: Rectangle::new(Point::zero(), Size::new(4, 3)),
    madctl: 0,
    is_inverted: false,
};

fn command(command: u8, data: &[u8]) -> Vec<Byte> {
    let data = data.iter().map(|data| Byte::Data(*data));
    [Byte::Command(command)].into_iter().chain(data).collect()
}

fn window(columns: [u8; 2], rows: [u8; 2]) -> Vec<Byte> {
    let caset = command(0x2A, &[0, columns[0], 0, columns[1]]);
    [caset, command(0x2B, &[0, rows[0], 0, rows[1]])].concat()
}

/// Returns a RAMWR or RAMWRC command with pixel data.
fn pixels(ram: u8, pixels: &[u16]) -> Vec<Byte> {
    let bytes: Vec<u8> = pixels
        .iter()
        .flat_map(|pixel| pixel.to_be_bytes())
        .collect();
    command(ram, &bytes)
}

/// Returns a controller after SLPOUT and DISPON, with 16 bits per pixel and a black memory.
fn started(panel: Panel) -> Controller {
    let mut controller = Controller::new(panel);
    let black = vec![0; (panel.memory.width * panel.memory.height) as usize];
    for commands in [
        command(0x11, &[]),
        command(0x3A, &[0x55]),
        command(0x29, &[]),
        pixels(0x2C, &black),
    ] {
        controller.receive_all(commands).unwrap();
    }
    controller
}

#[track_caller]
fn assert_shows(controller: &Controller, expected: &[u16]) {
    let picture = controller.picture().unwrap();
    let shown: Vec<u16> = picture
        .pixels()
        .iter()
        .map(|color| color.into_storage())
        .collect();
    assert_eq!(shown, expected);
}

#[test]
fn pixels_fill_the_window_and_wrap() {
    let mut controller = started(SMALL);
    controller.receive_all(window([1, 2], [1, 2])).unwrap();
    controller.receive_all(pixels(0x2C, &[1, 2, 3, 4])).unwrap();
    assert_shows(&controller, &[0, 0, 0, 0, 0, 1, 2, 0, 0, 3, 4, 0]);
    controller.receive_all(pixels(0x3C, &[5, 6, 7])).unwrap();
    assert_shows(&controller, &[0, 0, 0, 0, 0, 5, 6, 0, 0, 7, 4, 0]);
}

#[test]
fn a_partial_write_keeps_the_other_pixels() {
    let mut controller = started(SMALL);
    controller.receive_all(window([0, 3], [0, 0])).unwrap();
    controller.receive_all(pixels(0x2C, &[1, 2, 3])).unwrap();
    assert_shows(&controller, &[1, 2, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0]);
}

#[test]
fn ramwr_restarts_at_the_first_pixel_of_the_window() {
    let mut controller = started(SMALL);
    controller.receive_all(window([2, 3], [0, 1])).unwrap();
    controller.receive_all(pixels(0x2C, &[1, 2, 3])).unwrap();
    controller.receive_all(pixels(0x2C, &[4])).unwrap();
    assert_shows(&controller, &[0, 0, 4, 2, 0, 0, 3, 0, 0, 0, 0, 0]);
}

#[test]
fn ramwrc_continues_after_other_commands() {
    let mut controller = started(SMALL);
    controller.receive_all(pixels(0x2C, &[1])).unwrap();
    // Send NOP, then a manufacturer command. Its parameters must not become pixels.
    controller.receive_all(command(0x00, &[])).unwrap();
    controller
        .receive_all(command(0xB2, &[0xC, 0xC, 0, 0x33, 0x33]))
        .unwrap();
    controller.receive_all(pixels(0x3C, &[2])).unwrap();
    assert_shows(&controller, &[1, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]);
}

#[test]
fn a_command_discards_an_incomplete_pixel() {
    let mut controller = started(SMALL);
    controller.receive_all(pixels(0x2C, &[1])).unwrap();
    controller.receive_all(command(0x3C, &[0xAB])).unwrap();
    controller.receive_all(pixels(0x3C, &[2])).unwrap();
    assert_shows(&controller, &[1, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]);
}

#[test]
fn excess_parameters_are_ignored() {
    let mut controller = started(SMALL);
    controller
        .receive_all(command(0x2A, &[0, 1, 0, 1, 9, 9, 9]))
        .unwrap();
    controller.receive_all(pixels(0x2C, &[1, 2])).unwrap();
    assert_shows(&controller, &[0, 1, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0]);
}

#[test]
fn shows_only_the_memory_behind_the_glass() {
    let glass = Rectangle::new(Point::new(1, 1), Size::new(2, 2));
    let mut controller = started(Panel { glass, ..SMALL });
    let all: Vec<u16> = (0..12).collect();
    controller.receive_all(pixels(0x2C, &all)).unwrap();
    assert_shows(&controller, &[5, 6, 9, 10]);
}

#[test]
fn orientation_applies_to_pixels_written_later() {
    let mut controller = started(SMALL);
    controller.receive_all(command(0x36, &[0x60])).unwrap();
    // The window has three columns and four rows. Its first line is the right edge of the
    // panel.
    controller.receive_all(window([0, 2], [0, 3])).unwrap();
    controller.receive_all(pixels(0x2C, &[1, 2, 3, 4])).unwrap();
    assert_shows(&controller, &[0, 0, 4, 1, 0, 0, 0, 2, 0, 0, 0, 3]);
    controller.receive_all(command(0x36, &[0])).unwrap();
    assert_shows(&controller, &[0, 0, 4, 1, 0, 0, 0, 2, 0, 0, 0, 3]);
}

#[test]
fn wrong_color_order_and_inversion_are_visible() {
    let red = Rgb565::RED.into_storage();
    let shown = |panel: Panel, madctl: u8, inversion: u8| {
        let mut controller = started(panel);
        controller.receive_all(command(0x36, &[madctl])).unwrap();
        controller.receive_all(command(inversion, &[])).unwrap();
        controller.receive_all(pixels(0x2C, &[red; 12])).unwrap();
        controller.picture().unwrap().pixels()[0]
    };
    let (bgr, negative) = (
        Panel { madctl: 8, ..SMALL },
        Panel {
            is_inverted: true,
            ..SMALL
        },
    );
    assert_eq!(shown(SMALL, 0, 0x20), Rgb565::RED);
    assert_eq!(shown(bgr, 8, 0x20), Rgb565::RED);
    assert_eq!(shown(bgr, 0, 0x20), Rgb565::BLUE);
    assert_eq!(shown(SMALL, 8, 0x20), Rgb565::BLUE);
    assert_eq!(shown(negative, 0, 0x21), Rgb565::RED);
    assert_eq!(shown(negative, 0, 0x20), Rgb565::CYAN);
}

#[test]
fn reports_why_a_display_is_blank() {
    let mut controller = Controller::new(SMALL);
    assert_eq!(controller.picture(), Err(BlankError::Asleep));
    controller.receive_all(command(0x11, &[])).unwrap();
    assert_eq!(controller.picture(), Err(BlankError::Off));
    controller.receive_all(command(0x29, &[])).unwrap();
    controller.receive_all(command(0x3A, &[0x05])).unwrap();
    controller.receive_all(pixels(0x2C, &[7; 5])).unwrap();
    let at = Point::new(1, 1);
    assert_eq!(controller.picture(), Err(BlankError::NeverWritten { at }));
    controller.receive_all(pixels(0x3C, &[7; 7])).unwrap();
    assert_shows(&controller, &[7; 12]);

    for (off, error) in [(0x28, BlankError::Off), (0x10, BlankError::Asleep)] {
        controller.receive_all(command(off, &[])).unwrap();
        assert_eq!(controller.picture(), Err(error));
    }
}

#[test]
fn swreset_resets_everything_except_the_pixels() {
    let mut controller = started(SMALL);
    controller.receive_all(command(0x36, &[0xE8])).unwrap();
    controller.receive_all(command(0x21, &[])).unwrap();
    controller.receive_all(window([1, 1], [1, 1])).unwrap();
    controller.receive_all(command(0x01, &[])).unwrap();
    assert_eq!(controller.picture(), Err(BlankError::Asleep));
    assert_eq!(
        controller.receive_all(pixels(0x2C, &[1])),
        Err(StreamError::PixelFormat { colmod: 0x66 })
    );
    for commands in [
        command(0x11, &[]),
        command(0x29, &[]),
        command(0x3A, &[0x55]),
    ] {
        controller.receive_all(commands).unwrap();
    }
    controller.receive_all(pixels(0x2C, &[1, 2])).unwrap();
    assert_shows(&controller, &[1, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]);
}

#[test]
fn reports_invalid_streams() {
    let wrong = |bytes: Vec<Byte>| {
        let error = started(SMALL).receive_all(bytes).unwrap_err();
        (error, error.to_string())
    };
    let no_command = Controller::new(SMALL).receive(Byte::Data(0x2C));
    assert_eq!(no_command, Err(StreamError::NoCommand { data: 0x2C }));

    let (error, text) = wrong(command(0x37, &[0, 1]));
    assert_eq!(error, StreamError::NotModeled { command: 0x37 });
    assert_eq!(text, "command 0x37 is not supported by this model");

    let (_, text) = wrong([command(0x2A, &[0, 1]), command(0x2C, &[])].concat());
    assert_eq!(text, "command 0x2A has 2 of 4 parameters");

    let (_, text) = wrong(command(0x2B, &[0, 2, 0, 1]));
    assert_eq!(
        text,
        "command 0x2B: last address 1 is before first address 2"
    );

    let (error, _) = wrong([window([0, 3], [0, 3]), pixels(0x2C, &[1])].concat());
    let (last, memory) = (Point::new(3, 3), Size::new(4, 3));
    assert_eq!(error, StreamError::OutsideOfMemory { last, memory });

    // Column 3 is inside a memory of 4x3 pixels, but outside if the axes are swapped.
    let landscape = [command(0x36, &[0x20]), pixels(0x2C, &[1])].concat();
    let (last, memory) = (Point::new(3, 2), Size::new(3, 4));
    assert_eq!(
        wrong(landscape).0,
        StreamError::OutsideOfMemory { last, memory }
    );

    let (error, _) = wrong([window([0, 1], [0, 1]), pixels(0x3C, &[1])].concat());
    assert_eq!(error, StreamError::NothingToContinue);
}

#[test]
fn random_streams_do_not_panic() {
    let mut random = fastrand::Rng::with_seed(1);
    // The random streams contain known commands, so that they reach most states of the
    // controller.
    let known = [
        0x01, 0x11, 0x20, 0x21, 0x29, 0x2A, 0x2B, 0x2C, 0x36, 0x3A, 0x3C,
    ];
    for panel in [
        SMALL,
        Panel::ILI9341_320X240,
        Panel {
            memory: Size::zero(),
            ..SMALL
        },
    ] {
        let mut controller = Controller::new(panel);
        for _ in 0..100_000 {
            _ = controller.receive(match random.u8(..) {
                0 => Byte::Command(random.u8(..)),
                1..40 => Byte::Command(known[random.usize(..known.len())]),
                40..200 => Byte::Data(random.u8(..6)),
                _ => Byte::Data(random.u8(..)),
            });
        }
        _ = controller.picture();
    }
}
