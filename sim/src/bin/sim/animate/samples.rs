//! Samples of an animation's colors.

use embedded_graphics::geometry::Size;

use super::frames::Frames;
use crate::outcome::Outcome;

/// Largest number of pixels in the samples.
const PIXELS: usize = 1 << 18;

/// Largest number of frames that are sampled.
const FRAMES: usize = 64;

/// Returns the pixels of some frames in a small size. The samples of a short and small animation
/// are all of its pixels.
pub(super) fn samples(frames: &mut Frames<'_>) -> Outcome<Vec<[u8; 3]>> {
    let count = frames.count();
    let (number, size) = plan(count, frames.size());
    let mut pixels = Vec::new();
    for sample in 0..number {
        let image = frames.sample(sample * count / number, size)?;
        pixels.extend_from_slice(image.as_image_buffer().as_raw().as_chunks().0);
    }
    Ok(pixels)
}

/// Returns the number of sampled frames and their size.
fn plan(frames: usize, size: Size) -> (usize, Size) {
    let Size { width, height } = size;
    let pixels = width as usize * height as usize;
    if frames * pixels <= PIXELS {
        return (frames, size);
    }
    let number = frames.clamp(1, FRAMES);
    let share = (PIXELS / number) as f64 / pixels as f64;
    let side = |side: u32| ((f64::from(side) * share.sqrt()) as u32).clamp(1, side);
    (number, Size::new(side(width), side(height)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn large_animations_have_small_samples() {
        assert_eq!(plan(100, Size::new(64, 32)), (100, Size::new(64, 32)));
        assert_eq!(plan(80, Size::new(320, 240)), (64, Size::new(73, 55)));
        assert_eq!(plan(2, Size::new(8192, 8192)), (2, Size::new(362, 362)));
        assert_eq!(plan(10_000, Size::new(8192, 1)), (64, Size::new(5792, 1)));
    }
}
