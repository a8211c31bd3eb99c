//! A picture that is drawn beside another task, in an async executor.
//!
//! Each step ends at an `.await`, so the other task has its turn however long
//! the picture takes. In firmware, take the executor of Embassy or RTIC and its
//! `yield_now`; those here are just as long as it takes to show it.

use std::cell::Cell;
use std::convert::Infallible;
use std::future::poll_fn;
use std::pin::pin;
use std::task::{Context, Poll, Waker};

use embedded_graphics::mock_display::MockDisplay;
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::*;
use whitted::render::{RenderProgress, Step};
use whitted::{
    Camera, Color, Light, Material, MaterialId, Object, Real, Renderer, Scene, SceneBuffer, Vec3,
};

static SCENE: Scene = Scene {
    lights: &[Light::point(
        Vec3::lit("-6", "11", "7"),
        Color::gray(Real::ONE),
    )],
    materials: &[Material {
        kd: Color::lit("0.6", "0.04", "0.03"),
        ..Material::BLACK
    }],
    objects: &[Object::sphere(
        Vec3::lit("0", "1", "0"),
        Real::ONE,
        MaterialId(0),
    )],
    ..Scene::new(Camera::new(
        Vec3::lit("0", "2", "8"),
        Vec3::lit("0", "1", "0"),
        Real::lit("33"),
    ))
};

/// Draws on until the picture is complete.
async fn draw<D>(
    renderer: &mut Renderer<'_>,
    mut drawing: RenderProgress,
    display: &mut D,
) -> Result<(), D::Error>
where
    D: DrawTarget,
    D::Color: whitted::render::DisplayColor,
{
    while !drawing.is_complete() {
        renderer.step(&mut drawing, Step::Rays(500), display)?;
        yield_now().await;
    }
    Ok(())
}

/// Blinks as long as it is dark.
async fn blink(is_dark: &Cell<bool>) -> u32 {
    let mut blinks = 0;
    while is_dark.get() {
        blinks += 1;
        yield_now().await;
    }
    blinks
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut buffer = SceneBuffer::<1, 1, 1>::new();
    let scene = buffer.prepare(&SCENE)?;
    let mut display = MockDisplay::<Rgb565>::new();
    // Blocks are drawn over by smaller ones.
    display.set_allow_overdraw(true);
    let mut renderer = Renderer::new(&scene, display.size());

    let is_dark = Cell::new(true);
    let drawing = RenderProgress::progressive(display.bounding_box());
    let picture = async {
        let Ok(()): Result<(), Infallible> = draw(&mut renderer, drawing, &mut display).await;
        is_dark.set(false);
    };
    let blinks = run_both(picture, blink(&is_dark));
    println!("the LED blinked {blinks} times, then the picture was complete");
    Ok(())
}

/// Lets the other tasks have a turn.
async fn yield_now() {
    let mut is_over = false;
    poll_fn(|context| {
        if std::mem::replace(&mut is_over, true) {
            return Poll::Ready(());
        }
        context.waker().wake_by_ref();
        Poll::Pending
    })
    .await
}

/// Runs two tasks in turns, to the end of the second.
fn run_both<T>(first: impl Future<Output = ()>, second: impl Future<Output = T>) -> T {
    let (mut first, mut second) = (pin!(first), pin!(second));
    let mut context = Context::from_waker(Waker::noop());
    let mut is_first_over = false;
    loop {
        if !is_first_over {
            is_first_over = first.as_mut().poll(&mut context).is_ready();
        }
        if let Poll::Ready(output) = second.as_mut().poll(&mut context) {
            return output;
        }
    }
}
