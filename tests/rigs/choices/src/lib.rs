//! Parts that all programs of the rig `choices` share.
//!
//! Each program in `src/bin` draws a scene and makes one choice. The difference of the flash of two
//! programs is the cost of the choice. The programs are linked but never run. Scenes pass through
//! `black_box` and are empty, so the programs contain the code for all scenes, but no scene data.

#![no_std]

use core::hint::black_box;
use core::panic::PanicInfo;

use embedded_graphics_core::prelude::Size;
use mps2::NullDisplay;
use whitted::{Camera, PreparedScene, Real, Renderer, Scene, SceneBuffer, real, vec3};

/// Buffer for the scenes of all programs.
pub type Buffer = SceneBuffer<8, 2, 8>;

/// An empty scene.
pub static SCENE: Scene = Scene::new(Camera::new(vec3!(0, 2, 8), vec3!(0, 1, 0), real!(33)));

/// Bytes of a compiled scene, which the compiler does not know.
pub fn compiled() -> &'static [u8] {
    black_box(&[])
}

/// Size of the picture, which the compiler does not know.
pub fn size() -> Size {
    black_box(Size::new(240, 240))
}

/// Returns the display, which discards all pixels.
pub fn display() -> NullDisplay {
    NullDisplay::new(size())
}

/// Draws a scene from top to bottom.
pub fn draw(scene: &PreparedScene<'_>) {
    let Ok(()) = Renderer::new(black_box(scene), size()).draw(&mut display());
}

/// Prepares a scene that is written in code, and draws it. Ignores errors of the scene.
#[inline(always)]
pub fn prepare_and_draw(scene: &Scene<'_>) {
    if let Ok(scene) = Buffer::new().prepare(black_box(scene)) {
        draw(&scene);
    }
}

/// Returns a number that the compiler does not know.
pub fn number() -> Real {
    black_box(Real::ONE)
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    loop {}
}
