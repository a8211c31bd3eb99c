//! Frame memory of a controller and its write cursor.

use embedded_graphics_core::geometry::{Point, Size};
use embedded_graphics_core::primitives::Rectangle;

use crate::address::AddressOrder;
use crate::error::StreamError;

/// Range of columns or rows. Both ends are included.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Range {
    pub(crate) first: u16,
    pub(crate) last: u16,
}

impl Range {
    pub(crate) fn all(length: u32) -> Self {
        Self {
            first: 0,
            last: length.saturating_sub(1) as u16,
        }
    }
}

/// Address of the next pixel in a window.
///
/// The cursor moves line by line. After the last pixel of the window, it returns to the
/// first pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Cursor {
    columns: Range,
    rows: Range,
    column: u16,
    row: u16,
}

impl Cursor {
    /// Creates a cursor at the first pixel of a window.
    pub(crate) fn new(columns: Range, rows: Range) -> Self {
        Self {
            columns,
            rows,
            column: columns.first,
            row: rows.first,
        }
    }

    /// Returns the address of the current pixel and moves the cursor to the next pixel.
    fn advance(&mut self) -> Point {
        let at = Point::new(self.column.into(), self.row.into());
        if self.column < self.columns.last {
            self.column += 1;
            return at;
        }
        self.column = self.columns.first;
        self.row = if self.row < self.rows.last {
            self.row + 1
        } else {
            self.rows.first
        };
        at
    }
}

#[derive(Clone, Debug)]
pub(crate) struct Memory {
    size: Size,
    /// Pixels, row by row. A pixel is `None` if no driver has written it since power-on.
    pixels: Vec<Option<u16>>,
}

impl Memory {
    pub(crate) fn new(size: Size) -> Self {
        Self {
            size,
            pixels: vec![None; size.width as usize * size.height as usize],
        }
    }

    pub(crate) fn get(&self, position: Point) -> Option<u16> {
        *self.pixels.get(self.index(position)?)?
    }

    /// Writes a pixel at the cursor and advances the cursor.
    pub(crate) fn write(
        &mut self,
        cursor: &mut Cursor,
        order: AddressOrder,
        pixel: u16,
    ) -> Result<(), StreamError> {
        let memory = order.extent(self.size);
        let last = Point::new(cursor.columns.last.into(), cursor.rows.last.into());
        if !Rectangle::new(Point::zero(), memory).contains(last) {
            return Err(StreamError::OutsideOfMemory { last, memory });
        }
        let index = self.index(order.to_memory(cursor.advance(), self.size));
        if let Some(slot) = index.and_then(|index| self.pixels.get_mut(index)) {
            *slot = Some(pixel);
        }
        Ok(())
    }

    fn index(&self, position: Point) -> Option<usize> {
        let (x, y) = (
            u32::try_from(position.x).ok()?,
            u32::try_from(position.y).ok()?,
        );
        let is_inside = x < self.size.width && y < self.size.height;
        is_inside.then(|| y as usize * self.size.width as usize + x as usize)
    }
}
