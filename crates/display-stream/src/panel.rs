use embedded_graphics_core::geometry::{Point, Size};
use embedded_graphics_core::primitives::Rectangle;

use crate::address::AddressOrder;

/// The size of the memory of the ST7789 and of the ILI9341.
const MEMORY: Size = Size::new(240, 320);

/// A controller's memory, and the glass that shows it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Panel {
    /// Columns and rows of the controller's memory.
    pub memory: Size,
    /// The part of the memory that is behind the glass.
    pub glass: Rectangle,
    /// The address mode (MADCTL) that fits how the panel is built and mounted:
    /// under it, lines run from left to right and from the top down, and red is red.
    pub upright: u8,
    /// Whether it takes INVON to show colors as they are sent.
    pub is_inverted: bool,
}

impl Panel {
    /// An ST7789 with a square IPS panel, as hats for the Raspberry Pi Pico
    /// have it.
    pub const ST7789_240X240: Self = Self {
        memory: MEMORY,
        glass: Rectangle::new(Point::zero(), Size::new(240, 240)),
        upright: 0,
        is_inverted: true,
    };

    /// The same controller and kind of panel, all of its memory shown; upright.
    pub const ST7789_240X320: Self = Self {
        glass: Rectangle::new(Point::zero(), MEMORY),
        ..Self::ST7789_240X240
    };

    /// An ILI9341 with its usual panel, lying on its side: columns run backwards,
    /// the order of colors is BGR.
    pub const ILI9341_320X240: Self = Self {
        memory: MEMORY,
        glass: Rectangle::new(Point::zero(), MEMORY),
        upright: 0x28,
        is_inverted: false,
    };

    /// Of what a person sees.
    pub fn size(&self) -> Size {
        AddressOrder::of(self.upright).extent(self.glass.size)
    }

    /// Where in the memory the pixel is that a person sees here.
    pub(crate) fn place(&self, seen: Point) -> Point {
        self.glass.top_left + AddressOrder::of(self.upright).place(seen, self.glass.size)
    }
}
