//! Renders scenes to a [`Picture`] of linear colors.

use embedded_graphics_core::geometry::Size;
use whitted::codec::Crc32;
use whitted::observer::Observer;
use whitted::{Color, PreparedScene, Renderer};

use crate::picture::Picture;

/// Renders a scene with 16-bit linear samples.
pub fn linear(scene: &PreparedScene<'_>, size: Size) -> Picture {
    trace(&mut Renderer::new(scene, size), |_| {})
}

/// Renders all lines of a picture. After each line, calls `line_done` with the line number.
pub fn trace<O: Observer>(
    renderer: &mut Renderer<'_, O>,
    mut line_done: impl FnMut(u32),
) -> Picture {
    lines(renderer.size(), |y, line| {
        renderer.render_line(y, line);
        line_done(y);
    })
}

/// Assembles a picture from lines. For each line, calls `render` with the line number and a slice.
/// `render` writes the pixels of the line to the slice.
pub fn lines(size: Size, mut render: impl FnMut(u32, &mut [Color<u16>])) -> Picture {
    let Size { width, height } = size;
    let mut pixels = vec![Color::<u16>::default(); width as usize * height as usize];
    // `chunks_exact_mut` panics if the chunk size is 0, so the chunk size is at least 1. A picture
    // with the width 0 has no pixels, so the loop ends at once.
    for (y, line) in (0..height).zip(pixels.chunks_exact_mut(width.max(1) as usize)) {
        render(y, line);
    }
    Picture {
        width,
        height,
        pixels,
    }
}

/// Returns the CRC-32 of a picture's samples. The samples of a pixel are in the order red, green,
/// blue, and each sample is big-endian.
///
/// A scene has the same checksum on every target, because all targets render the same bits.
pub fn checksum(picture: &Picture) -> u32 {
    let mut crc = Crc32::new();
    for pixel in &picture.pixels {
        crc.update_pixel(*pixel);
    }
    crc.finish()
}
