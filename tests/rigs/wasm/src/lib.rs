//! Draws a compiled scene in WebAssembly. `checksum.mjs` runs the module in Node.js.

use std::cell::RefCell;

use embedded_graphics_core::geometry::Size;
use whitted::codec::Crc32;
use whitted::{Color, Renderer, SceneBuffer};

thread_local! {
    static SCENE: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
}

/// Allocates `length` bytes for a compiled scene and returns their address.
#[unsafe(no_mangle)]
pub extern "C" fn reserve(length: usize) -> *mut u8 {
    SCENE.with_borrow_mut(|scene| {
        scene.resize(length, 0);
        scene.as_mut_ptr()
    })
}

/// Returns the checksum of the picture, or 0 if the scene cannot be decoded.
#[unsafe(no_mangle)]
pub extern "C" fn checksum(width: u32, height: u32) -> u32 {
    let mut buffer = Box::new(SceneBuffer::<64, 8, 64>::new());
    let mut crc = Crc32::new();
    SCENE.with_borrow(|scene| {
        let Ok(scene) = buffer.decode(scene) else {
            return 0;
        };
        let mut renderer = Renderer::new(&scene, Size::new(width, height));
        let mut line = vec![Color::<u16>::default(); width as usize];
        for y in 0..height {
            renderer.render_line(y, &mut line);
            line.iter().for_each(|pixel| crc.update_pixel(*pixel));
        }
        crc.finish()
    })
}
