//! The memory of a controller, and where the next pixel goes.

use embedded_graphics_core::geometry::{Point, Size};
use embedded_graphics_core::primitives::Rectangle;

use crate::address::AddressOrder;
use crate::error::StreamError;

/// A range of columns or rows, both ends included.
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

/// Where pixels go: from the window's first on, line by line, and from its last
/// to its first again.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Cursor {
    columns: Range,
    rows: Range,
    column: u16,
    row: u16,
}

impl Cursor {
    /// At the start of a window.
    pub(crate) fn new(columns: Range, rows: Range) -> Self {
        Self {
            columns,
            rows,
            column: columns.first,
            row: rows.first,
        }
    }

    /// This pixel's address; goes on to the next.
    fn next(&mut self) -> Point {
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
    /// Nothing where nothing was written since power-on.
    pixels: Vec<Option<u16>>,
}

impl Memory {
    pub(crate) fn new(size: Size) -> Self {
        Self {
            size,
            pixels: vec![None; size.width as usize * size.height as usize],
        }
    }

    pub(crate) fn at(&self, place: Point) -> Option<u16> {
        *self.pixels.get(self.index(place)?)?
    }

    /// Writes a pixel where the cursor is, which moves on.
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
        let index = self.index(order.place(cursor.next(), self.size));
        if let Some(place) = index.and_then(|index| self.pixels.get_mut(index)) {
            *place = Some(pixel);
        }
        Ok(())
    }

    fn index(&self, place: Point) -> Option<usize> {
        let (x, y) = (u32::try_from(place.x).ok()?, u32::try_from(place.y).ok()?);
        let is_inside = x < self.size.width && y < self.size.height;
        is_inside.then(|| y as usize * self.size.width as usize + x as usize)
    }
}
