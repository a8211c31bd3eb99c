use embedded_graphics_core::geometry::{Point, Size};
use embedded_graphics_core::primitives::Rectangle;

use crate::render::column_range::ColumnRange;

/// The part of a row of blocks that has not been drawn yet. It is clipped to the picture.
pub(crate) struct RowSpan {
    pub(crate) y: u32,
    /// Columns of the pixels to trace.
    pub(crate) columns: ColumnRange,
    /// Side of a block in pixels.
    pub(crate) block: u8,
    /// Line below the last line of the area to draw.
    pub(crate) bottom: u32,
}

impl RowSpan {
    /// Returns a row of single pixels.
    pub(crate) fn line(y: u32, columns: ColumnRange) -> Self {
        Self {
            y,
            columns,
            block: 1,
            bottom: y.saturating_add(1),
        }
    }

    /// Returns true if the columns have no gaps. All pixels of the row are then traced.
    pub(crate) fn is_contiguous(&self) -> bool {
        self.columns.spacing == 0
    }

    /// Returns the area from column `x` to the end of the row. The row must consist of single
    /// pixels.
    pub(crate) fn area(&self, x: u32) -> Rectangle {
        let width = self.columns.to.saturating_sub(x);
        Rectangle::new(self.point(x), Size::new(width, 1))
    }

    /// Returns the block whose top left pixel is in column `x`, clipped to the area to draw.
    pub(crate) fn block_at(&self, x: u32) -> Rectangle {
        let side = |start: u32, end: u32| u32::from(self.block).min(end.saturating_sub(start));
        let size = Size::new(side(x, self.columns.to), side(self.y, self.bottom));
        Rectangle::new(self.point(x), size)
    }

    /// Returns the position of the pixel in column `x`.
    pub(crate) fn point(&self, x: u32) -> Point {
        Point::new(x as i32, self.y as i32)
    }
}
