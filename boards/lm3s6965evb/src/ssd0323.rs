use core::convert::Infallible;

use embedded_graphics::{pixelcolor::Gray4, prelude::*, primitives::Rectangle};
use embedded_hal::{digital::OutputPin, spi::SpiDevice};

const WIDTH: usize = 128;
const HEIGHT: usize = 64;
/// Two pixels share a byte, the left one has the high nibble.
const ROW_BYTES: usize = WIDTH / 2;

/// The pixels as the controller stores them, row by row.
pub(crate) type Pixels = [u8; ROW_BYTES * HEIGHT];

/// A black picture.
pub(crate) const BLACK: Pixels = [0; ROW_BYTES * HEIGHT];

/// Sets up a panel of 128x64 pixels, and leaves the display off.
const SET_UP: &[u8] = &[
    0xAE, // display off
    0x81, 50,   // contrast, of 127
    0x85, // half of the full current
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
    0xBF, 0x0D, // low voltage of segments
    0xAD, 0x03, // DC-DC converter on
];
const DISPLAY_ON: u8 = 0xAF;
const SET_COLUMNS: u8 = 0x15;
const SET_ROWS: u8 = 0x75;

/// A 128x64 OLED of 16 grays on a Solomon SSD0323 controller.
///
/// Pixels go to the display at once, area by area: one window and one burst.
/// The driver keeps a copy of them, as the controller cannot be read, and its
/// bytes hold two pixels each.
pub(crate) struct Ssd0323<'p, SPI, DC> {
    spi: SPI,
    /// Low for commands, high for data.
    data: DC,
    pixels: &'p mut Pixels,
}

impl<'p, SPI, DC> Ssd0323<'p, SPI, DC>
where
    SPI: SpiDevice,
    DC: OutputPin<Error = Infallible>,
{
    /// Sets the display up, shows `pixels` and turns it on.
    pub(crate) fn new(spi: SPI, data: DC, pixels: &'p mut Pixels) -> Result<Self, SPI::Error> {
        let mut display = Self { spi, data, pixels };
        display.command(SET_UP)?;
        display.send(&display.bounding_box())?;
        display.command(&[DISPLAY_ON])?;
        Ok(display)
    }

    /// Changes a pixel of the copy, if there is one at this point.
    fn set(&mut self, point: Point, color: Gray4) {
        // Below 0 is far to the right as well.
        let (x, y) = (point.x as u32 as usize, point.y as u32 as usize);
        if x < WIDTH && y < HEIGHT {
            let byte = &mut self.pixels[y * ROW_BYTES + x / 2];
            *byte = match x % 2 {
                0 => *byte & 0x0F | color.luma() << 4,
                _ => *byte & 0xF0 | color.luma(),
            };
        }
    }

    /// Sends an area of the copy, which must not reach beyond the display.
    fn send(&mut self, area: &Rectangle) -> Result<(), SPI::Error> {
        let Some(bottom_right) = area.bottom_right() else {
            return Ok(());
        };
        let [left, right] = [area.top_left.x, bottom_right.x].map(|x| x as u8 / 2);
        let [top, bottom] = [area.top_left.y, bottom_right.y].map(|y| y as u8);
        self.command(&[SET_COLUMNS, left, right, SET_ROWS, top, bottom])?;

        let Ok(()) = self.data.set_high();
        for row in usize::from(top)..=usize::from(bottom) {
            let row = row * ROW_BYTES;
            self.spi
                .write(&self.pixels[row + usize::from(left)..=row + usize::from(right)])?;
        }
        Ok(())
    }

    fn command(&mut self, bytes: &[u8]) -> Result<(), SPI::Error> {
        let Ok(()) = self.data.set_low();
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

    /// Sends the smallest area that holds all of the pixels.
    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), SPI::Error>
    where
        I: IntoIterator<Item = Pixel<Gray4>>,
    {
        let (mut least, mut most) = (Point::new_equal(i32::MAX), Point::new_equal(i32::MIN));
        let mut any = false;
        for Pixel(point, color) in pixels {
            if self.bounding_box().contains(point) {
                any = true;
                self.set(point, color);
                least = least.component_min(point);
                most = most.component_max(point);
            }
        }
        match any {
            true => self.send(&Rectangle::with_corners(least, most)),
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
