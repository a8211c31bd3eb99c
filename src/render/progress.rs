//! The progress of drawing a picture. A program can interrupt drawing and resume it later.
//!
//! A picture is drawn in passes. Each pass draws rows of square blocks. A block has the color of
//! its top left pixel, the only pixel of the block that is traced. The first pass covers the
//! picture with large blocks. In each later pass, the blocks are half as wide as before. A later
//! pass traces only three of every four blocks, because the top left pixel of the fourth block has
//! already been traced. In scanline order, the first blocks are single pixels, so there is only one
//! pass.

use embedded_graphics_core::primitives::Rectangle;

use crate::render::bounds::Bounds;
use crate::render::column_range::ColumnRange;
use crate::render::row_span::RowSpan;

/// Side length, in pixels, of the blocks of the first pass in progressive order.
const COARSEST: u8 = 16;

/// Progress of drawing a picture, or an area of it, by [`Renderer::step`](crate::Renderer::step).
///
/// A `RenderProgress` is 24 bytes of plain data. It does not refer to the renderer or the display,
/// so it can be stored, copied or dropped between steps. A copy resumes drawing at the place where
/// the copy was made. All steps must use the same scene, picture size and display.
///
/// This microcontroller loop feeds a watchdog and reads a button while rays are traced, because a
/// single pixel of a slow scene can take minutes:
///
/// ```
/// # use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb565, prelude::*};
/// # use embedded_graphics::primitives::Rectangle;
/// # use whitted::{Camera, Scene, SceneBuffer, real, vec3};
/// # struct Watchdog(u32);
/// # impl Watchdog { fn feed(&mut self) { self.0 += 1; } }
/// # struct Button;
/// # impl Button { fn is_pressed(&self) -> bool { false } }
/// # let (mut watchdog, button) = (Watchdog(0), Button);
/// # let mut display = MockDisplay::<Rgb565>::new();
/// # display.set_allow_overdraw(true);
/// # let scene = Scene::new(Camera::new(vec3!(0, 2, 8), vec3!(0, 1, 0), real!(33)));
/// # let mut buffer = SceneBuffer::<1, 1, 1>::new();
/// # let scene = buffer.prepare(&scene).unwrap();
/// use core::ops::ControlFlow;
/// use whitted::Renderer;
/// use whitted::observer::Poller;
/// use whitted::render::{RenderProgress, Step};
///
/// // 200 rays and tests take about 1 ms on a Cortex-M0+, and 10 ms at most.
/// let poller = Poller::new(200, || {
///     watchdog.feed();
///     match button.is_pressed() {
///         true => ControlFlow::Break(()),
///         false => ControlFlow::Continue(()),
///     }
/// });
/// let mut renderer = Renderer::with_observer(&scene, display.size(), poller);
/// let mut progress = RenderProgress::progressive(display.bounding_box());
/// while !progress.is_complete() && !renderer.observer().is_interrupted() {
///     renderer.step(&mut progress, Step::Line, &mut display).unwrap();
/// }
/// # assert!(progress.is_complete() && watchdog.0 == 64 * 64 / 200);
/// ```
///
/// To redraw a part of a picture, start a new `RenderProgress` with the area of that part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RenderProgress {
    /// Area to draw, in coordinates of the display.
    area: Rectangle,
    /// Top left pixel of the next block, relative to the visible part of the area.
    x: u16,
    y: u16,
    /// Side of the blocks of the first pass: a power of two.
    coarsest: u8,
    /// Side of the blocks of the current pass, or 0 if the area is complete.
    block: u8,
}

/// Amount of work that one call of [`Renderer::step`](crate::Renderer::step) does.
///
/// A step always ends when the picture is complete.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Step {
    /// Draws the rest of the current row of blocks. In scanline order, this row is a line of
    /// pixels.
    Line,
    /// Draws the rest of the current pass. In scanline order, there is only one pass.
    Pass,
    /// Traces the given number of rays, including shadow rays, and then finishes the current pixel.
    /// A pixel takes at most 4096 rays plus their shadow rays, which can take minutes. A
    /// [`Poller`](crate::observer::Poller) can interrupt a step inside a pixel. `Rays(0)` does
    /// nothing.
    Rays(u32),
}

impl RenderProgress {
    /// Starts to draw an area line by line, from top to bottom.
    ///
    /// The area is in coordinates of the display. It is clipped to the picture and to the bounding
    /// box of the display.
    pub fn scanlines(area: Rectangle) -> Self {
        Self::new(area, 1)
    }

    /// Starts to draw an area in five passes with blocks of 16, 8, 4, 2 and 1 pixels a side.
    ///
    /// The first pass covers the whole area but traces only 1/256 of its pixels. Together, the five
    /// passes trace each pixel once. They send four times as many pixels to the display as scanline
    /// order does, because they draw small blocks over large ones.
    ///
    /// The area is in coordinates of the display. It is clipped to the picture and to the bounding
    /// box of the display.
    pub fn progressive(area: Rectangle) -> Self {
        Self::new(area, COARSEST)
    }

    fn new(area: Rectangle, coarsest: u8) -> Self {
        Self {
            area,
            x: 0,
            y: 0,
            coarsest,
            block: coarsest,
        }
    }

    /// Returns true if the whole area is drawn.
    pub fn is_complete(&self) -> bool {
        self.block == 0
    }

    /// Returns the side of the blocks of the current pass in pixels, or 0 if the area is complete.
    pub fn block(&self) -> u32 {
        self.block.into()
    }

    /// Returns the area to draw, in coordinates of the display.
    pub(crate) fn area(&self) -> &Rectangle {
        &self.area
    }

    /// Returns the part of the current row that has not been drawn. Returns `None` if the area is
    /// complete. `bounds` is the visible part of the area.
    pub(crate) fn row(&mut self, bounds: Bounds) -> Option<RowSpan> {
        self.settle(bounds);
        let Bounds {
            left,
            top,
            right,
            bottom,
        } = bounds;
        (!self.is_complete()).then(|| RowSpan {
            y: top + u32::from(self.y),
            columns: ColumnRange {
                from: left + u32::from(self.x),
                to: right,
                spacing: self.stride().trailing_zeros() as u8,
            },
            block: self.block,
            bottom,
        })
    }

    /// Records that the next block of the current row has been drawn.
    pub(crate) fn advance(&mut self, bounds: Bounds) {
        self.x = self.x.saturating_add(self.stride());
        self.settle(bounds);
    }

    /// Records that the current row has been drawn up to column `x` of the picture, which is
    /// excluded.
    pub(crate) fn advance_to(&mut self, x: u32, bounds: Bounds) {
        let x = x.saturating_sub(bounds.left);
        self.x = u16::try_from(x).unwrap_or(u16::MAX);
        self.settle(bounds);
    }

    /// Records that the current row is complete, and moves to the next row.
    pub(crate) fn finish_row(&mut self, bounds: Bounds) {
        self.x = u16::MAX;
        self.settle(bounds);
    }

    /// If the current row is complete, moves to the next row. If the current pass is complete,
    /// moves to the next pass.
    fn settle(&mut self, bounds: Bounds) {
        let (width, height) = (bounds.width(), bounds.height());
        if width == 0 {
            self.block = 0;
        }
        while self.block > 0 {
            if self.y >= height {
                self.block /= 2;
                self.y = 0;
            } else if self.x >= width {
                self.y = self.y.saturating_add(self.block.into());
            } else {
                return;
            }
            // An earlier pass either traced the first pixel of this row or traced no pixel of the
            // row.
            let traced = if self.is_new_row() { 0 } else { self.block };
            self.x = traced.into();
        }
    }

    /// Returns true if no earlier pass has traced pixels of the current row. In the first pass,
    /// this is true of all rows. In later passes, it is true of every other row.
    fn is_new_row(&self) -> bool {
        self.block == self.coarsest || self.y & u16::from(self.block) != 0
    }

    /// Returns the distance, in columns, between the pixels that are traced in the current row.
    fn stride(&self) -> u16 {
        let stride = u16::from(self.block);
        if self.is_new_row() {
            stride
        } else {
            2 * stride
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn has_documented_size() {
        assert_eq!(size_of::<RenderProgress>(), 24);
    }
}
