//! A ball hovers over a user interface. Only the pixels of the ball are drawn.
//!
//! `cargo run --example over_interface` writes `over_interface.png`.

pub(crate) mod common;

use std::cell::RefCell;
use std::convert::Infallible;
use std::error::Error;

use common::Display;
use embedded_graphics::mono_font::MonoTextStyle;
use embedded_graphics::mono_font::ascii::{FONT_6X13, FONT_9X15_BOLD};
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::{PrimitiveStyle, Rectangle, RoundedRectangle};
use embedded_graphics::text::Text;
use whitted::render::{AaSample, Picture, SampleCount};
use whitted::{
    Background, Camera, Color, Light, Material, MaterialId, Object, Scene, SceneBuffer, color,
    real, vec3,
};

const SIZE: Size = Size::new(240, 160);

/// Part of the display in which the ball hovers.
const BALL: Rectangle = Rectangle::new(Point::new(122, 40), Size::new(112, 112));

const PAPER: Rgb565 = Rgb565::new(27, 55, 28);
const INK: Rgb565 = Rgb565::new(3, 8, 6);
const BAR: Rgb565 = Rgb565::new(4, 18, 14);

/// A copper ball and a smaller glass ball. The background is the color of the interface. It is not
/// drawn, but the balls reflect it, and their smooth edges blend into it.
pub(crate) static SCENE: Scene = Scene {
    background: Background::Gradient {
        horizon: color!(0.87, 0.87, 0.90),
        zenith: color!(0.35, 0.5, 0.75),
    },
    lights: &[Light::point(vec3!(-30, 50, 40), color!(1.1, 1.05, 1))],
    materials: &[
        Material {
            ka: color!(0.12, 0.05, 0.02),
            kd: color!(0.55, 0.24, 0.10),
            ks: color!(0.7, 0.6, 0.5),
            shininess: real!(90),
            kr: color!(0.38, 0.22, 0.12),
            ..Material::BLACK
        },
        Material {
            ka: color!(0.01, 0.05, 0.06),
            kd: color!(0.05, 0.35, 0.42),
            ks: Color::gray(real!(0.8)),
            shininess: real!(200),
            kr: Color::gray(real!(0.2)),
            ..Material::BLACK
        },
    ],
    objects: &[
        Object::sphere(vec3!(0, 0, 0), real!(1), MaterialId(0)),
        Object::sphere(vec3!(-0.85, -0.65, 0.7), real!(0.32), MaterialId(1)),
    ],
    ..Scene::new(Camera::new(
        vec3!(0, 0.6, 6),
        vec3!(-0.1, -0.03, 0),
        real!(23),
    ))
};

/// Draws the interface behind the ball.
fn draw_interface(display: &mut Display) -> Result<(), Infallible> {
    display.clear(PAPER)?;
    let bar = Rectangle::new(Point::zero(), Size::new(SIZE.width, 24));
    bar.into_styled(PrimitiveStyle::with_fill(BAR))
        .draw(display)?;
    let title = MonoTextStyle::new(&FONT_9X15_BOLD, PAPER);
    Text::new("Workshop", Point::new(8, 17), title).draw(display)?;
    let style = MonoTextStyle::new(&FONT_6X13, INK);
    let rows = ["Copper  0.42 kg", "Glass   0.18 kg", "Furnace  860 C"];
    for (row, y) in rows.into_iter().zip([34, 72, 110]) {
        let card = Rectangle::new(Point::new(8, y), Size::new(224, 30));
        RoundedRectangle::with_equal_corners(card, Size::new(6, 6))
            .into_styled(PrimitiveStyle::with_stroke(INK, 1))
            .draw(display)?;
        Text::new(row, Point::new(18, y + 19), style).draw(display)?;
    }
    Ok(())
}

/// Draws the interface and the ball.
pub(crate) fn picture() -> Result<Display, Box<dyn Error>> {
    let mut display = Display::new(SIZE);
    draw_interface(&mut display)?;

    let mut buffer = SceneBuffer::<2, 1, 2>::new();
    let scene = buffer.prepare(&SCENE)?;
    // Smooth edges need two samples for each column of the picture.
    let memory = RefCell::new([AaSample::BLACK; 2 * BALL.size.width as usize]);
    Picture::new(&scene, BALL.top_left, BALL.size)
        .transparent()
        .antialiased(SampleCount::Sixteen, &memory)?
        .draw(&mut display)?;
    Ok(display)
}

fn main() -> Result<(), Box<dyn Error>> {
    common::save("over_interface.png", 2, &[picture()?])
}
