use embedded_graphics_core::geometry::{Point, Size};
use embedded_graphics_core::primitives::Rectangle;

use crate::address::AddressOrder;

/// Columns and rows in the memory of both the ST7789 and the ILI9341.
const MEMORY: Size = Size::new(240, 320);

/// Geometry and color order of a display panel and its controller.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Panel {
    /// Columns and rows of the controller memory.
    pub memory: Size,
    /// Visible part of the memory.
    pub glass: Rectangle,
    /// MADCTL value that suits the way in which the panel is built and mounted.
    ///
    /// If the driver sets this MADCTL value, pixels run from left to right, lines run from
    /// top to bottom, and red and blue are not swapped.
    pub madctl: u8,
    /// True if the panel shows colors as they are sent only after the command INVON.
    pub is_inverted: bool,
}

impl Panel {
    /// ST7789 with a square IPS panel. Display hats for the Raspberry Pi Pico often have
    /// this panel.
    pub const ST7789_240X240: Self = Self {
        memory: MEMORY,
        glass: Rectangle::new(Point::zero(), Size::new(240, 240)),
        madctl: 0,
        is_inverted: true,
    };

    /// ST7789 with an IPS panel of 240x320 pixels in portrait format.
    pub const ST7789_240X320: Self = Self {
        glass: Rectangle::new(Point::zero(), MEMORY),
        ..Self::ST7789_240X240
    };

    /// ILI9341 with its usual panel, in landscape format and with BGR color order.
    pub const ILI9341_320X240: Self = Self {
        memory: MEMORY,
        glass: Rectangle::new(Point::zero(), MEMORY),
        madctl: 0x28,
        is_inverted: false,
    };

    /// Returns the width and height of the visible picture, in the orientation of the
    /// mounted panel.
    pub fn size(&self) -> Size {
        AddressOrder::from_madctl(self.madctl).extent(self.glass.size)
    }

    /// Converts a screen position to a position in the controller memory.
    pub(crate) fn memory_position(&self, screen: Point) -> Point {
        self.glass.top_left
            + AddressOrder::from_madctl(self.madctl).to_memory(screen, self.glass.size)
    }
}
