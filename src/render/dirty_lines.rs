//! What of a line changed since the frame before.

use core::ops::Range;

use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{Point, Size};
use embedded_graphics_core::pixelcolor::IntoStorage;
use embedded_graphics_core::primitives::Rectangle;

/// Sends a display only what changed since the frame before: for a slow bus, or
/// for e-paper, which need not be refreshed when nothing was sent.
///
/// It remembers a hash of each [`SEGMENT`](Self::SEGMENT) of a line, in memory of
/// the caller's: 4 bytes for 32 pixels, 9.6 KB for 320x240, where a framebuffer of
/// `Rgb565` would take 154 KB. A change that leaves the hash as it was, one in
/// 2^32, is missed until the segment changes again.
///
/// ```
/// # use embedded_graphics::mock_display::MockDisplay;
/// # use whitted::{Camera, Real, Scene, SceneBuffer, Vec3};
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*};
/// use whitted::{DirtyLines, Renderer};
///
/// const SIZE: Size = Size::new(64, 64);
/// let mut hashes = [0; DirtyLines::hashes(SIZE)];
/// let mut changes = DirtyLines::new(SIZE.width, &mut hashes);
/// let mut line = [Rgb565::BLACK; SIZE.width as usize];
///
/// # let mut display = MockDisplay::new();
/// # let scene = Scene::new(Camera::new(Vec3::lit("0", "2", "8"), Vec3::lit("0", "1", "0"), Real::lit("33")));
/// # let mut buffer = SceneBuffer::<1, 1, 1>::new();
/// # let scene = buffer.prepare(&scene).unwrap();
/// // For each frame:
/// # for frame in 0..2 {
/// let mut renderer = Renderer::new(&scene, SIZE);
/// let mut sent = 0;
/// for y in 0..SIZE.height {
///     renderer.render_line(y, &mut line);
///     sent += changes.send_line(y, &line, &mut display).unwrap();
/// }
/// # assert_eq!(sent, if frame == 0 { 64 * 64 } else { 0 });
/// # }
/// ```
#[derive(Debug)]
pub struct DirtyLines<'m> {
    /// Line by line; 0 where it is not known what the display shows.
    hashes: &'m mut [u32],
    width: u32,
}

impl<'m> DirtyLines<'m> {
    /// How many pixels are sent or not sent together: whole bytes on every
    /// display.
    pub const SEGMENT: u32 = 32;

    /// How many hashes a picture takes.
    pub const fn hashes(size: Size) -> usize {
        size.width.div_ceil(Self::SEGMENT) as usize * size.height as usize
    }

    /// For lines of `width` pixels. What the display shows is not known, so
    /// the first frame is sent as a whole.
    ///
    /// Lines beyond those that there are hashes for are always sent as a whole.
    pub fn new(width: u32, hashes: &'m mut [u32]) -> Self {
        hashes.fill(0);
        Self { hashes, width }
    }

    /// Forgets what the display shows, for example when it was reset or
    /// something else was drawn on it: the next frame is sent as a whole.
    pub fn forget(&mut self) {
        self.hashes.fill(0);
    }

    /// Sends what changed of line `y`, and returns how many pixels that were.
    ///
    /// Neighboring segments are sent by one call of `fill_contiguous`. What is longer
    /// than the line is left out.
    ///
    /// # Errors
    /// The display's own, at once. What the failed call should have changed counts
    /// as not known from then on, so the line can be sent again.
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
            if self.known(y, index..index + 1) == [hash] {
                continue;
            }
            if run.end != index {
                sent += self.send_run(y, line, run, target)?;
                run = index..index;
            }
            run.end = index + 1;
            self.known(y, index..index + 1).fill(hash);
        }
        sent += self.send_run(y, line, run, target)?;
        Ok(sent)
    }

    /// Sends neighboring segments, which are known from now on, unless that fails.
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
        let area = Rectangle::new(Point::new(start as i32, y as i32), size);
        let outcome = target.fill_contiguous(&area, pixels.iter().copied());
        if outcome.is_err() {
            self.known(y, run).fill(0);
        }
        outcome.map(|()| size.width)
    }

    /// The hashes of some segments of a line, as far as there is memory for them.
    fn known(&mut self, y: u32, segments: Range<usize>) -> &mut [u32] {
        let line = (self.width.div_ceil(Self::SEGMENT) as usize).saturating_mul(y as usize);
        let known = self.hashes.get_mut(line..).unwrap_or_default();
        let end = segments.end.min(known.len());
        known.get_mut(segments.start..end).unwrap_or_default()
    }
}

/// MurmurHash3 (Appleby 2011) of colors as words, and never 0.
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
