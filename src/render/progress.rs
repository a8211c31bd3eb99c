//! How far a picture is drawn, and in which order.
//!
//! A picture is drawn in passes, and a pass has rows of blocks: squares in the
//! color of the pixel at their top left. The first pass has blocks in a dense grid;
//! each pass after it halves them, and traces the three of four that have no
//! pixel yet. Scanlines are a picture whose first blocks are single pixels.

use embedded_graphics_core::geometry::{Point, Size};
use embedded_graphics_core::primitives::Rectangle;

use crate::render::camera_rays::{ColumnRange, MAX_SIDE};

/// The side of the first blocks in progressive order.
const COARSEST: u8 = 16;

/// How far a picture, or an area of it, is drawn: what
/// [`Renderer::step`](crate::Renderer::step) goes on from.
///
/// It is plain data of 14 bytes that knows neither the renderer nor the display.
/// Between steps it can be kept, moved, copied or dropped, with or without the
/// renderer; whoever has a copy goes on from there. It belongs to one picture: the
/// same scene, size and display.
///
/// Whatever else is to be done is done between steps. On a microcontroller:
///
/// ```
/// # use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb565, prelude::*};
/// # use embedded_graphics::primitives::Rectangle;
/// # use whitted::{Camera, Real, Scene, SceneBuffer, Vec3};
/// # struct Watchdog(u32);
/// # impl Watchdog { fn feed(&mut self) { self.0 += 1; } }
/// # struct Button;
/// # impl Button { fn is_pressed(&self) -> bool { false } }
/// # let (mut watchdog, button) = (Watchdog(0), Button);
/// # let mut display = MockDisplay::<Rgb565>::new();
/// # display.set_allow_overdraw(true);
/// # let scene = Scene::new(Camera::new(Vec3::lit("0", "2", "8"), Vec3::lit("0", "1", "0"), Real::lit("33")));
/// # let mut buffer = SceneBuffer::<1, 1, 1>::new();
/// # let scene = buffer.prepare(&scene).unwrap();
/// use whitted::{RenderProgress, Renderer};
/// use whitted::render::Step;
///
/// let mut renderer = Renderer::new(&scene, display.size());
/// let mut drawing = RenderProgress::progressive(display.bounding_box());
/// while !drawing.is_complete() {
///     // So many rays take about 10 ms on a Cortex-M0+ at 133 MHz.
///     renderer.step(&mut drawing, Step::Rays(800), &mut display).unwrap();
///     watchdog.feed();
///     if button.is_pressed() {
///         break; // and draw something else
///     }
/// }
/// # assert!(drawing.is_complete() && watchdog.0 == 6);
/// ```
///
/// A part of a picture is drawn again by a drawing of that area, in whichever
/// order: `RenderProgress::scanlines(area)`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RenderProgress {
    left: u16,
    top: u16,
    right: u16,
    bottom: u16,
    /// The next block.
    x: u16,
    y: u16,
    /// The side of the blocks of the first pass: a power of two.
    coarsest: u8,
    /// That of this pass; 0 when there is no more.
    block: u8,
}

/// How far [`Renderer::step`](crate::Renderer::step) goes.
///
/// Each step ends with the picture at the latest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Step {
    /// To the end of the line: of a line of pixels, or of a row of blocks.
    Line,
    /// To the end of the pass: all blocks of a size. Scanlines have one pass.
    Pass,
    /// Until so many rays are traced, shadow rays included, and then to the end
    /// of the pixel, which has at most 4096 rays that are not shadow rays.
    /// `Rays(0)` does nothing.
    Rays(u32),
}

impl RenderProgress {
    /// A drawing of an area line by line, from the top; nothing is drawn yet.
    ///
    /// What of the area is outside of the picture is left out.
    pub fn scanlines(area: Rectangle) -> Self {
        Self::new(area, 1)
    }

    /// A drawing of an area in five passes: in blocks of 16 pixels a side, then
    /// of 8, 4, 2, and 1. After the first, which is 1/256 of the work, there is
    /// something everywhere.
    ///
    /// Each pixel is traced once. All passes together send a display four times
    /// as many pixels as scanlines do.
    pub fn progressive(area: Rectangle) -> Self {
        Self::new(area, COARSEST)
    }

    fn new(area: Rectangle, coarsest: u8) -> Self {
        let Rectangle { top_left, size } = area;
        let clip = |edge: i64| edge.clamp(0, MAX_SIDE.into()) as u16;
        let end = |start: i32, length: u32| clip(i64::from(start) + i64::from(length));
        let (left, top) = (clip(top_left.x.into()), clip(top_left.y.into()));
        Self {
            left,
            top,
            right: end(top_left.x, size.width),
            bottom: end(top_left.y, size.height),
            x: left,
            y: top,
            coarsest,
            block: coarsest,
        }
    }

    /// Whether all is drawn.
    pub fn is_complete(&self) -> bool {
        self.block == 0
    }

    /// The side of the blocks that are next, in pixels; 0 if all is drawn.
    pub fn block(&self) -> u32 {
        self.block.into()
    }

    /// What is next in a picture of `size`.
    pub(crate) fn row(&mut self, size: Size) -> Option<RowSpan> {
        self.settle(size);
        let (right, bottom) = self.ends(size);
        (!self.is_complete()).then(|| RowSpan {
            y: self.y.into(),
            columns: ColumnRange {
                from: self.x.into(),
                to: right.into(),
                spacing: self.stride().trailing_zeros() as u8,
            },
            block: self.block,
            bottom: bottom.into(),
        })
    }

    /// Goes on by so many pixels of the row.
    pub(crate) fn advance(&mut self, pixels: u32, size: Size) {
        let way = pixels.saturating_mul(self.stride().into());
        let way = u16::try_from(way).unwrap_or(u16::MAX);
        self.x = self.x.saturating_add(way);
        self.settle(size);
    }

    /// Goes on to the next row.
    pub(crate) fn finish_row(&mut self, size: Size) {
        self.x = self.right;
        self.settle(size);
    }

    /// Goes on to where there is a pixel to be traced.
    fn settle(&mut self, size: Size) {
        let (right, bottom) = self.ends(size);
        if self.left >= right {
            self.block = 0;
        }
        while self.block > 0 {
            if self.y >= bottom {
                self.block /= 2;
                self.y = self.top;
            } else if self.x >= right {
                self.y = self.y.saturating_add(self.block.into());
            } else {
                return;
            }
            // An earlier pass has the first pixel of a row, unless all are new.
            let done = if self.is_new_row() { 0 } else { self.block };
            self.x = self.left.saturating_add(done.into());
        }
    }

    /// Right and bottom, of what is inside of the picture.
    fn ends(&self, size: Size) -> (u16, u16) {
        let least = |end: u16, side: u32| u32::from(end).min(side) as u16;
        (
            least(self.right, size.width),
            least(self.bottom, size.height),
        )
    }

    /// Whether no earlier pass has a pixel of this row: it has those of each
    /// second row.
    fn is_new_row(&self) -> bool {
        self.block == self.coarsest || (self.y - self.top) & u16::from(self.block) != 0
    }

    /// From one pixel that is traced in this row to the next.
    fn stride(&self) -> u16 {
        let stride = u16::from(self.block);
        if self.is_new_row() {
            stride
        } else {
            2 * stride
        }
    }
}

/// The rest of a row of blocks, in the picture.
pub(crate) struct RowSpan {
    pub(crate) y: u32,
    /// Of the pixels that are to be traced.
    pub(crate) columns: ColumnRange,
    pub(crate) block: u8,
    bottom: u32,
}

impl RowSpan {
    /// A line of pixels.
    pub(crate) fn line(y: u32, columns: ColumnRange) -> Self {
        Self {
            y,
            columns,
            block: 1,
            bottom: y.saturating_add(1),
        }
    }

    /// Whether each pixel from the next to the end is to be traced.
    pub(crate) fn is_whole(&self) -> bool {
        self.columns.spacing == 0
    }

    /// Where its pixels are, if they are not of blocks.
    pub(crate) fn area(&self) -> Rectangle {
        let ColumnRange { from, to, .. } = self.columns;
        Rectangle::new(self.point(from), Size::new(to - from, 1))
    }

    /// The block whose top left pixel is in this column, up to the area's ends.
    pub(crate) fn block_at(&self, x: u32) -> Rectangle {
        let within = |start: u32, end: u32| u32::from(self.block).min(end.saturating_sub(start));
        let size = Size::new(within(x, self.columns.to), within(self.y, self.bottom));
        Rectangle::new(self.point(x), size)
    }

    pub(crate) fn point(&self, x: u32) -> Point {
        Point::new(x as i32, self.y as i32)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_drawing_takes_as_many_bytes_as_documented() {
        assert_eq!(size_of::<RenderProgress>(), 14);
    }
}
