//! From the addresses of pixels to their places in the memory.

use embedded_graphics_core::geometry::{Point, Size};

/// How addresses run over a memory: MADCTL's upper three bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct AddressOrder {
    /// MV: columns of addresses are rows of the memory.
    exchanged: bool,
    /// MX: the memory's columns run backwards.
    columns_reversed: bool,
    /// MY: the memory's rows run backwards.
    rows_reversed: bool,
}

impl AddressOrder {
    /// As this MADCTL says.
    pub(crate) const fn of(madctl: u8) -> Self {
        Self {
            exchanged: madctl & 0x20 != 0,
            columns_reversed: madctl & 0x40 != 0,
            rows_reversed: madctl & 0x80 != 0,
        }
    }

    /// How many columns and rows of addresses a memory of this size has.
    pub(crate) const fn extent(self, memory: Size) -> Size {
        if self.exchanged {
            Size::new(memory.height, memory.width)
        } else {
            memory
        }
    }

    /// Where in a memory of this size the pixel at (column, row) is.
    pub(crate) const fn place(self, at: Point, memory: Size) -> Point {
        let Point { x, y } = if self.exchanged {
            Point::new(at.y, at.x)
        } else {
            at
        };
        let last = Point::new(memory.width as i32 - 1, memory.height as i32 - 1);
        Point::new(
            if self.columns_reversed { last.x - x } else { x },
            if self.rows_reversed { last.y - y } else { y },
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MEMORY: Size = Size::new(240, 320);

    fn first_and_second(madctl: u8) -> [(i32, i32); 2] {
        [Point::zero(), Point::new(1, 0)].map(|at| {
            let Point { x, y } = AddressOrder::of(madctl).place(at, MEMORY);
            (x, y)
        })
    }

    /// The table "Display data direction" of the ST7789's data sheet.
    #[test]
    fn lines_start_and_run_as_the_data_sheet_says() {
        assert_eq!(first_and_second(0x00), [(0, 0), (1, 0)]);
        assert_eq!(first_and_second(0x80), [(0, 319), (1, 319)]);
        assert_eq!(first_and_second(0x40), [(239, 0), (238, 0)]);
        assert_eq!(first_and_second(0xC0), [(239, 319), (238, 319)]);
        assert_eq!(first_and_second(0x20), [(0, 0), (0, 1)]);
        assert_eq!(first_and_second(0xA0), [(0, 319), (0, 318)]);
        assert_eq!(first_and_second(0x60), [(239, 0), (239, 1)]);
        assert_eq!(first_and_second(0xE0), [(239, 319), (239, 318)]);
    }
}
