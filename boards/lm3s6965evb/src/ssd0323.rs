use core::convert::Infallible;

use embedded_graphics::{pixelcolor::Gray4, prelude::*, primitives::Rectangle};
use embedded_hal::{digital::OutputPin, spi::SpiDevice};

const WIDTH: usize = 128;
const HEIGHT: usize = 64;
/// Number of bytes per row. A byte holds two pixels, with the left pixel in the high
/// nibble.
const ROW_BYTES: usize = WIDTH / 2;

/// Framebuffer in the pixel format of the SSD0323, row by row.
pub(crate) type Pixels = [u8; ROW_BYTES * HEIGHT];

/// Black framebuffer.
pub(crate) const BLACK: Pixels = [0; ROW_BYTES * HEIGHT];

/// Commands that initialize a 128x64 panel. They leave the display switched off.
const INIT: &[u8] = &[
    0xAE, // display off
    0x81, 50,   // contrast: 50 of 127
    0x85, // half current range
    0xA0, 0x52, // remap: COM split and reversed, nibbles swapped, rows first
    0xA1, 0, // start line
    0xA2, 0x4C, // display offset
    0xA4, // display mode: normal
    0xA8, 63, // multiplex ratio 1:64
    0xB1, 0x22, // phase lengths: 2 clocks each
    0xB2, 70, // row period, in clocks
    0xB3, 0xF1, // fastest oscillator, divided by 2
    0xB8, 0x01, 0x11, 0x22, 0x32, 0x43, 0x54, 0x65, 0x76, // gray scale table
    0xBC, 0x10, // precharge voltage
    0xBE, 0x02, // VCOMH
    0xBF, 0x0D, // segment low voltage
    0xAD, 0x03, // DC-DC converter on
];
const DISPLAY_ON: u8 = 0xAF;
const SET_COLUMNS: u8 = 0x15;
const SET_ROWS: u8 = 0x75;

/// Driver of a 128x64 OLED with 16 gray levels and a Solomon SSD0323 controller.
///
/// The driver sends each drawn area immediately. It selects the area as the window of the
/// display and sends the pixels. Two pixels share a byte of the controller memory. The
/// driver cannot read such a byte back to change one pixel, so it keeps a framebuffer.
pub(crate) struct Ssd0323<'p, SPI, DC> {
    spi: SPI,
    /// D/C pin: low for commands, high for data.
    data_or_command: DC,
    pixels: &'p mut Pixels,
}

impl<'p, SPI, DC> Ssd0323<'p, SPI, DC>
where
    SPI: SpiDevice,
    DC: OutputPin<Error = Infallible>,
{
    /// Initializes the display, shows `pixels` and turns the display on.
    pub(crate) fn new(
        spi: SPI,
        data_or_command: DC,
        pixels: &'p mut Pixels,
    ) -> Result<Self, SPI::Error> {
        let mut display = Self {
            spi,
            data_or_command,
            pixels,
        };
        display.command(INIT)?;
        display.send(&display.bounding_box())?;
        display.command(&[DISPLAY_ON])?;
        Ok(display)
    }

    /// Sets a pixel in the framebuffer. Points outside the display are ignored.
    fn set(&mut self, point: Point, color: Gray4) {
        // The cast turns negative coordinates into large values, which fail the bounds
        // check.
        let (x, y) = (point.x as u32 as usize, point.y as u32 as usize);
        if x < WIDTH && y < HEIGHT {
            let byte = &mut self.pixels[y * ROW_BYTES + x / 2];
            *byte = match x % 2 {
                0 => *byte & 0x0F | color.luma() << 4,
                _ => *byte & 0xF0 | color.luma(),
            };
        }
    }

    /// Sends an area of the framebuffer to the display. The area must be inside the
    /// display.
    fn send(&mut self, area: &Rectangle) -> Result<(), SPI::Error> {
        let Some(bottom_right) = area.bottom_right() else {
            return Ok(());
        };
        let [left, right] = [area.top_left.x, bottom_right.x].map(|x| x as u8 / 2);
        let [top, bottom] = [area.top_left.y, bottom_right.y].map(|y| y as u8);
        self.command(&[SET_COLUMNS, left, right, SET_ROWS, top, bottom])?;

        let Ok(()) = self.data_or_command.set_high();
        for row in usize::from(top)..=usize::from(bottom) {
            let row = row * ROW_BYTES;
            self.spi
                .write(&self.pixels[row + usize::from(left)..=row + usize::from(right)])?;
        }
        Ok(())
    }

    fn command(&mut self, bytes: &[u8]) -> Result<(), SPI::Error> {
        let Ok(()) = self.data_or_command.set_low();
        self.spi.write(bytes)
    }
}

impl<SPI, DC> OriginDimensions for Ssd0323<'_, SPI, DC> {
    fn size(&self) -> Size {
        Size::new(WIDTH as u32, HEIGHT as u32)
    }
}

impl<SPI, DC> DrawTarget for Ssd0323<'_, SPI, DC>
where
    SPI: SpiDevice,
    DC: OutputPin<Error = Infallible>,
{
    type Color = Gray4;
    type Error = SPI::Error;

    /// Draws the pixels into the framebuffer and sends the bounding box of these pixels to
    /// the display.
    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), SPI::Error>
    where
        I: IntoIterator<Item = Pixel<Gray4>>,
    {
        let (mut top_left, mut bottom_right) =
            (Point::new_equal(i32::MAX), Point::new_equal(i32::MIN));
        let mut is_changed = false;
        for Pixel(point, color) in pixels {
            if self.bounding_box().contains(point) {
                is_changed = true;
                self.set(point, color);
                top_left = top_left.component_min(point);
                bottom_right = bottom_right.component_max(point);
            }
        }
        match is_changed {
            true => self.send(&Rectangle::with_corners(top_left, bottom_right)),
            false => Ok(()),
        }
    }

    fn fill_contiguous<I>(&mut self, area: &Rectangle, colors: I) -> Result<(), SPI::Error>
    where
        I: IntoIterator<Item = Gray4>,
    {
        for (point, color) in area.points().zip(colors) {
            self.set(point, color);
        }
        self.send(&area.intersection(&self.bounding_box()))
    }

    fn fill_solid(&mut self, area: &Rectangle, color: Gray4) -> Result<(), SPI::Error> {
        self.fill_contiguous(
            &area.intersection(&self.bounding_box()),
            core::iter::repeat(color),
        )
    }
}
