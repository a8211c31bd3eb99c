//! Sends only those parts of a line to the display that changed since the previous frame.

use core::ops::Range;

use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{Point, Size};
use embedded_graphics_core::pixelcolor::IntoStorage;
use embedded_graphics_core::primitives::Rectangle;

/// Sends only the segments of a line that changed since the previous frame.
///
/// `DirtyLines` suits displays on a slow bus. It also suits e-paper, which needs no refresh if
/// nothing was sent.
///
/// `DirtyLines` stores a hash of 4 bytes for each segment of 32 pixels. The caller provides the
/// memory. The hashes for a picture of 320x240 pixels take 9.6 KB, while a framebuffer of `Rgb565`
/// would take 154 KB. One change of a segment in 2^32 does not change the hash. Such a change is
/// not sent until the segment changes again.
///
/// ```
/// # use embedded_graphics::mock_display::MockDisplay;
/// # use whitted::{Camera, Scene, SceneBuffer, real, vec3};
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*};
/// use whitted::Renderer;
/// use whitted::render::DirtyLines;
///
/// const SIZE: Size = Size::new(64, 64);
/// let mut hashes = [0; DirtyLines::hashes(SIZE)];
/// let mut dirty_lines = DirtyLines::new(SIZE.width, &mut hashes);
/// let mut line = [Rgb565::BLACK; SIZE.width as usize];
///
/// # let mut display = MockDisplay::new();
/// # let scene = Scene::new(Camera::new(vec3!(0, 2, 8), vec3!(0, 1, 0), real!(33)));
/// # let mut buffer = SceneBuffer::<1, 1, 1>::new();
/// # let scene = buffer.prepare(&scene).unwrap();
/// // For each frame:
/// # for frame in 0..2 {
/// let mut renderer = Renderer::new(&scene, SIZE);
/// let mut sent = 0;
/// for y in 0..SIZE.height {
///     renderer.render_line(y, &mut line);
///     sent += dirty_lines.send_line(y, &line, &mut display).unwrap();
/// }
/// # assert_eq!(sent, if frame == 0 { 64 * 64 } else { 0 });
/// # }
/// ```
#[derive(Debug)]
pub struct DirtyLines<'m> {
    /// Hashes of the segments, line by line. The hash of a segment is 0 if it is not known what the
    /// display shows there.
    hashes: &'m mut [u32],
    width: u32,
}

impl<'m> DirtyLines<'m> {
    /// Number of pixels per segment. A segment fills whole bytes in every color format.
    pub const SEGMENT: u32 = 32;

    /// Returns the number of hashes that a picture of `size` needs.
    pub const fn hashes(size: Size) -> usize {
        size.width.div_ceil(Self::SEGMENT) as usize * size.height as usize
    }

    /// Creates `DirtyLines` for lines of `width` pixels. All segments of the first frame will be
    /// sent.
    ///
    /// If `hashes` is too short, the segments without a hash are sent in every frame.
    pub fn new(width: u32, hashes: &'m mut [u32]) -> Self {
        hashes.fill(0);
        Self { hashes, width }
    }

    /// Forgets what the display shows, so that all segments of the next frame are sent.
    ///
    /// Call `forget` after a reset of the display, or after drawing something else on it.
    pub fn forget(&mut self) {
        self.hashes.fill(0);
    }

    /// Sends the changed segments of line `y` and returns the number of pixels sent.
    ///
    /// The top left pixel of the picture is at the top left of the target's bounding box. Adjacent
    /// changed segments are sent by one call of `fill_contiguous`. Pixels of `line` beyond
    /// the width of the picture are ignored.
    ///
    /// # Errors
    /// Sending stops at the first error of the display and returns that error. The segments of the
    /// failed `fill_contiguous` lose their hashes, so that sending the line again repeats them.
    pub fn send_line<D>(
        &mut self,
        y: u32,
        line: &[D::Color],
        target: &mut D,
    ) -> Result<u32, D::Error>
    where
        D: DrawTarget,
        D::Color: IntoStorage<Storage: Into<u32>>,
    {
        let line = line.get(..self.width as usize).unwrap_or(line);
        let mut run = 0..0;
        let mut sent = 0;
        for (index, segment) in line.chunks(Self::SEGMENT as usize).enumerate() {
            let hash = hash(segment);
            if self.hashes_mut(y, index..index + 1) == [hash] {
                continue;
            }
            if run.end != index {
                sent += self.send_run(y, line, run, target)?;
                run = index..index;
            }
            run.end = index + 1;
            self.hashes_mut(y, index..index + 1).fill(hash);
        }
        sent += self.send_run(y, line, run, target)?;
        Ok(sent)
    }

    /// Sends adjacent segments by one call of `fill_contiguous`. If the call fails, the hashes of
    /// the segments are set to 0, so that the segments will be sent again.
    fn send_run<D>(
        &mut self,
        y: u32,
        line: &[D::Color],
        run: Range<usize>,
        target: &mut D,
    ) -> Result<u32, D::Error>
    where
        D: DrawTarget,
    {
        let segment = Self::SEGMENT as usize;
        let (start, end) = (run.start * segment, line.len().min(run.end * segment));
        let Some(pixels @ [_, ..]) = line.get(start..end) else {
            return Ok(0);
        };
        let size = Size::new(pixels.len() as u32, 1);
        let at = target.bounding_box().top_left + Point::new(start as i32, y as i32);
        let area = Rectangle::new(at, size);
        let outcome = target.fill_contiguous(&area, pixels.iter().copied());
        if outcome.is_err() {
            self.hashes_mut(y, run).fill(0);
        }
        outcome.map(|()| size.width)
    }

    /// Returns the hashes of the given segments of line `y`. Segments that have no hash, because
    /// the memory is too short, are left out.
    fn hashes_mut(&mut self, y: u32, segments: Range<usize>) -> &mut [u32] {
        let line = (self.width.div_ceil(Self::SEGMENT) as usize).saturating_mul(y as usize);
        let line = self.hashes.get_mut(line..).unwrap_or_default();
        let end = segments.end.min(line.len());
        line.get_mut(segments.start..end).unwrap_or_default()
    }
}

/// Hashes colors, each as a 32-bit word, by MurmurHash3 (Appleby 2011). Returns 1 instead of 0.
fn hash<C: Copy + IntoStorage<Storage: Into<u32>>>(colors: &[C]) -> u32 {
    let mut hash = 0_u32;
    for color in colors {
        let word = color.into_storage().into().wrapping_mul(0xcc9e_2d51);
        hash ^= word.rotate_left(15).wrapping_mul(0x1b87_3593);
        hash = hash
            .rotate_left(13)
            .wrapping_mul(5)
            .wrapping_add(0xe654_6b64);
    }
    for (shift, factor) in [(16, 0x85eb_ca6b), (13, 0xc2b2_ae35), (16, 1)] {
        hash = (hash ^ (hash >> shift)).wrapping_mul(factor);
    }
    hash.max(1)
}
