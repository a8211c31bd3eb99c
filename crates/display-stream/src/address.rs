//! Converts the pixel addresses that a driver uses to positions in the memory of the
//! display controller.

use embedded_graphics_core::geometry::{Point, Size};

/// Order in which pixel addresses run through the controller memory. The upper three bits
/// of the MADCTL register define this order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct AddressOrder {
    /// MV bit of MADCTL: true if address columns are memory rows.
    axes_swapped: bool,
    /// MX bit of MADCTL: true if memory columns run from right to left.
    columns_reversed: bool,
    /// MY bit of MADCTL: true if memory rows run from bottom to top.
    rows_reversed: bool,
}

impl AddressOrder {
    /// Reads the scan order from a MADCTL value.
    pub(crate) const fn from_madctl(madctl: u8) -> Self {
        Self {
            axes_swapped: madctl & 0x20 != 0,
            columns_reversed: madctl & 0x40 != 0,
            rows_reversed: madctl & 0x80 != 0,
        }
    }

    /// Returns the number of address columns and rows for a memory of size `memory`.
    pub(crate) const fn extent(self, memory: Size) -> Size {
        if self.axes_swapped {
            Size::new(memory.height, memory.width)
        } else {
            memory
        }
    }

    /// Converts the address `at` (column, row) to a position in a memory of size `memory`.
    pub(crate) const fn to_memory(self, at: Point, memory: Size) -> Point {
        let Point { x, y } = if self.axes_swapped {
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

    fn first_two_positions(madctl: u8) -> [(i32, i32); 2] {
        [Point::zero(), Point::new(1, 0)].map(|at| {
            let Point { x, y } = AddressOrder::from_madctl(madctl).to_memory(at, MEMORY);
            (x, y)
        })
    }

    /// The expected values are from the table "Display data direction" of the ST7789 data
    /// sheet.
    #[test]
    fn matches_the_data_sheet_for_all_eight_orders() {
        assert_eq!(first_two_positions(0x00), [(0, 0), (1, 0)]);
        assert_eq!(first_two_positions(0x80), [(0, 319), (1, 319)]);
        assert_eq!(first_two_positions(0x40), [(239, 0), (238, 0)]);
        assert_eq!(first_two_positions(0xC0), [(239, 319), (238, 319)]);
        assert_eq!(first_two_positions(0x20), [(0, 0), (0, 1)]);
        assert_eq!(first_two_positions(0xA0), [(0, 319), (0, 318)]);
        assert_eq!(first_two_positions(0x60), [(239, 0), (239, 1)]);
        assert_eq!(first_two_positions(0xE0), [(239, 319), (239, 318)]);
    }
}
