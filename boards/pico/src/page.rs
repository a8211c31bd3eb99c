use core::fmt::{self, Write};

use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_10X20};
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::*;
use embedded_graphics::text::{Baseline, Text};

const CELL: Size = FONT_10X20.character_size;

/// Shows a text and nothing else, broken between words.
pub(crate) fn show<D>(display: &mut D, text: fmt::Arguments<'_>)
where
    D: DrawTarget<Color = Rgb565> + OriginDimensions,
{
    // If the display does not even take text, there is nowhere to say so.
    _ = display.clear(Rgb565::BLACK);
    _ = Page {
        display,
        cursor: Point::zero(),
    }
    .write_fmt(text);
}

/// Types text on a display, from the top.
struct Page<'d, D> {
    display: &'d mut D,
    cursor: Point,
}

impl<D: DrawTarget<Color = Rgb565> + OriginDimensions> Page<'_, D> {
    fn word(&mut self, word: &str) -> Result<(), D::Error> {
        let style = MonoTextStyle::new(&FONT_10X20, Rgb565::WHITE);
        let width = word.trim_end_matches(' ').len() as i32 * CELL.width as i32;
        if self.cursor.x + width > self.display.size().width as i32 {
            self.cursor = Point::new(0, self.cursor.y + CELL.height as i32);
        }
        let text = Text::with_baseline(word, self.cursor, style, Baseline::Top);
        self.cursor = text.draw(self.display)?;
        Ok(())
    }
}

impl<D: DrawTarget<Color = Rgb565> + OriginDimensions> Write for Page<'_, D> {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        text.split_inclusive(' ')
            .try_for_each(|word| self.word(word))
            .map_err(|_| fmt::Error)
    }
}
