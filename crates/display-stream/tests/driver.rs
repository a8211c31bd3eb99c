//! Compares pictures drawn through the `mipidsi` driver with the expected pictures.

#![allow(clippy::unwrap_used)]

use std::convert::Infallible;

use display_stream::{Byte, Controller, Panel, Picture};
use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_10X20};
use embedded_graphics::primitives::{Circle, PrimitiveStyle, Rectangle};
use embedded_graphics::text::Text;
use embedded_graphics::{pixelcolor::Rgb565, prelude::*};
use embedded_hal::delay::DelayNs;
use mipidsi::interface::{Interface, InterfaceKind};
use mipidsi::models::{ILI9341Rgb565, Model, ST7789};
use mipidsi::options::{ColorInversion, ColorOrder, Orientation, Rotation};
use mipidsi::{Builder, Display, NoResetPin};

/// Driver interface that passes all bytes to the controller model.
struct ModelInterface(Controller);

impl ModelInterface {
    fn data(&mut self, bytes: impl IntoIterator<Item = u8>) {
        let bytes = bytes.into_iter().map(Byte::Data);
        self.0.receive_all(bytes).unwrap();
    }
}

impl Interface for ModelInterface {
    type Word = u8;
    type Error = Infallible;
    const KIND: InterfaceKind = InterfaceKind::Serial4Line;

    fn send_command(&mut self, command: u8, parameters: &[u8]) -> Result<(), Infallible> {
        self.0.receive(Byte::Command(command)).unwrap();
        self.data(parameters.iter().copied());
        Ok(())
    }

    fn send_pixels<const N: usize>(
        &mut self,
        pixels: impl IntoIterator<Item = [u8; N]>,
    ) -> Result<(), Infallible> {
        self.data(pixels.into_iter().flatten());
        Ok(())
    }

    fn send_repeated_pixel<const N: usize>(
        &mut self,
        pixel: [u8; N],
        count: u32,
    ) -> Result<(), Infallible> {
        self.send_pixels((0..count).map(|_| pixel))
    }
}

struct NoDelay;

impl DelayNs for NoDelay {
    fn delay_ns(&mut self, _: u32) {}
}

/// Draws a picture without symmetry. It has solid fills, single pixels, and a contiguous
/// area that exceeds the display.
fn draw_test_picture<D: DrawTarget<Color = Rgb565, Error: core::fmt::Debug>>(display: &mut D) {
    display.clear(Rgb565::CSS_DARK_SLATE_GRAY).unwrap();
    let (red, blue) = (
        PrimitiveStyle::with_fill(Rgb565::RED),
        PrimitiveStyle::with_stroke(Rgb565::BLUE, 3),
    );
    Rectangle::new(Point::new(10, 20), Size::new(100, 30))
        .into_styled(red)
        .draw(display)
        .unwrap();
    Circle::new(Point::new(150, 60), 70)
        .into_styled(blue)
        .draw(display)
        .unwrap();
    let style = MonoTextStyle::new(&FONT_10X20, Rgb565::YELLOW);
    Text::new("whitted", Point::new(30, 180), style)
        .draw(display)
        .unwrap();
    let area = Rectangle::new(Point::new(200, 200), Size::new(150, 10));
    let colors = (0..1500).map(|i| Rgb565::new(i as u8 & 31, (i >> 5) as u8, 0));
    display.fill_contiguous(&area, colors).unwrap();
}

fn assert_shows_test_picture<M>(
    panel: Panel,
    build: impl FnOnce(Builder<ModelInterface, M, NoResetPin>) -> Builder<ModelInterface, M, NoResetPin>,
    model: M,
) where
    M: Model<ColorFormat = Rgb565>,
{
    let builder = build(Builder::new(model, ModelInterface(Controller::new(panel))));
    let Ok(mut display): Result<Display<_, M, _>, _> = builder.init(&mut NoDelay) else {
        panic!("mipidsi does not support this panel")
    };
    let size = display.size();
    draw_test_picture(&mut display);
    let (ModelInterface(controller), ..) = display.release();

    let mut expected = Picture::new(size);
    draw_test_picture(&mut expected);
    let shown = controller.picture().unwrap();
    assert_eq!(shown.size(), expected.size());
    assert_eq!(shown.first_difference(&expected), None);
}

#[test]
fn shows_a_square_st7789() {
    let build = |builder: Builder<_, _, _>| {
        builder
            .display_size(240, 240)
            .invert_colors(ColorInversion::Inverted)
    };
    assert_shows_test_picture(Panel::ST7789_240X240, build, ST7789);
}

#[test]
fn shows_an_ili9341_in_landscape() {
    let landscape = Orientation::new().rotate(Rotation::Deg90).flip_vertical();
    let build =
        |builder: Builder<_, _, _>| builder.orientation(landscape).color_order(ColorOrder::Bgr);
    assert_shows_test_picture(Panel::ILI9341_320X240, build, ILI9341Rgb565);
}

/// The glass of the panel covers only a part of the memory, so each orientation of the
/// picture has its own offset in the memory.
#[test]
fn shows_every_orientation() {
    let unrotated = Orientation::new();
    let rotations = [
        Rotation::Deg0,
        Rotation::Deg90,
        Rotation::Deg180,
        Rotation::Deg270,
    ];
    let madctl = [[0x00, 0x60, 0xC0, 0xA0], [0x40, 0x20, 0x80, 0xE0]];
    for (orientation, madctl) in [unrotated, unrotated.flip_horizontal()]
        .into_iter()
        .zip(madctl)
    {
        for (rotation, madctl) in rotations.into_iter().zip(madctl) {
            let panel = Panel {
                glass: Rectangle::new(Point::new(20, 50), Size::new(210, 230)),
                madctl,
                ..Panel::ST7789_240X240
            };
            let orientation = Orientation {
                rotation,
                ..orientation
            };
            let build = |builder: Builder<_, _, _>| {
                let builder = builder.display_size(210, 230).display_offset(20, 50);
                builder
                    .invert_colors(ColorInversion::Inverted)
                    .orientation(orientation)
            };
            assert_shows_test_picture(panel, build, ST7789);
        }
    }
}
