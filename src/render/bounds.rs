use core::ops::Range;

use embedded_graphics_core::geometry::{Point, Size};
use embedded_graphics_core::primitives::Rectangle;

/// An area of a picture, in pixels of the picture. The area does not exceed the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Bounds {
    pub(crate) left: u32,
    pub(crate) top: u32,
    /// Column after the last column.
    pub(crate) right: u32,
    /// Line below the last line.
    pub(crate) bottom: u32,
}

impl Bounds {
    /// Returns the part of a picture that lies in both of two areas. `origin` is the position of
    /// the picture. This position and the areas are in coordinates of the display.
    ///
    /// The function is not inlined, because it runs only once per step.
    #[inline(never)]
    pub(crate) fn visible(origin: Point, size: Size, areas: [&Rectangle; 2]) -> Self {
        let (mut columns, mut lines) = (0..size.width, 0..size.height);
        for Rectangle { top_left, size } in areas {
            columns = clipped(columns, top_left.x, size.width, origin.x);
            lines = clipped(lines, top_left.y, size.height, origin.y);
        }
        Self {
            left: columns.start,
            top: lines.start,
            right: columns.end,
            bottom: lines.end,
        }
    }

    pub(crate) fn width(&self) -> u16 {
        self.right.saturating_sub(self.left) as u16
    }

    pub(crate) fn height(&self) -> u16 {
        self.bottom.saturating_sub(self.top) as u16
    }
}

/// Returns the part of `range` that lies within `length` pixels from `start`. `range` is relative
/// to `origin`.
fn clipped(range: Range<u32>, start: i32, length: u32, origin: i32) -> Range<u32> {
    let start = i64::from(start) - i64::from(origin);
    // `clamp` could panic.
    let clip = |edge: i64| edge.max(range.start.into()).min(range.end.into()) as u32;
    clip(start)..clip(start + i64::from(length))
}
