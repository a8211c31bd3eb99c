//! Rendering to a [`Picture`] of linear light.

use embedded_graphics_core::geometry::Size;
use whitted::codec::Crc32;
use whitted::observer::Observer;
use whitted::{Color, PreparedScene, Renderer};

use crate::picture::Picture;

/// Renders a scene to linear 16-bit samples.
pub fn linear(scene: &PreparedScene<'_>, size: Size) -> Picture {
    trace(&mut Renderer::new(scene, size), |_| {})
}

/// Renders line by line, telling each line that is done.
pub fn trace<O: Observer>(renderer: &mut Renderer<'_, O>, mut done: impl FnMut(u32)) -> Picture {
    lines(renderer.size(), |y, line| {
        renderer.render_line(y, line);
        done(y);
    })
}

/// A picture whose lines are rendered one by one, by their numbers.
pub fn lines(size: Size, mut render: impl FnMut(u32, &mut [Color<u16>])) -> Picture {
    let Size { width, height } = size;
    let mut pixels = vec![Color::<u16>::default(); width as usize * height as usize];
    // Zero is no chunk size; a picture without columns has no pixels anyway.
    for (y, line) in (0..height).zip(pixels.chunks_exact_mut(width.max(1) as usize)) {
        render(y, line);
    }
    Picture {
        width,
        height,
        pixels,
    }
}

/// The CRC-32 of a picture's samples: red, green, blue, each big-endian.
///
/// Every target gives the same picture of a scene, and so the same checksum.
pub fn checksum(picture: &Picture) -> u32 {
    let mut crc = Crc32::new();
    for pixel in &picture.pixels {
        crc.update_pixel(*pixel);
    }
    crc.finish()
}
