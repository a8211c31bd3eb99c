//! Draws any compiled scene in WebAssembly. `checksum.mjs` runs it in Node.js.

use std::cell::RefCell;

use embedded_graphics_core::geometry::Size;
use whitted::codec::Crc32;
use whitted::{Color, Renderer, SceneBuffer};

thread_local! {
    static SCENE: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
}

/// Makes room for a compiled scene of so many bytes, and says where.
#[unsafe(no_mangle)]
pub extern "C" fn room(length: usize) -> *mut u8 {
    SCENE.with_borrow_mut(|scene| {
        scene.resize(length, 0);
        scene.as_mut_ptr()
    })
}

/// The checksum of the scene's picture; 0 if it is none.
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
