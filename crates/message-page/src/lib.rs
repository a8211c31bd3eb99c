#![no_std]
//! Writes an error message on a display, for firmware that cannot draw its scene.

use core::fmt;

use embedded_graphics::{
    mono_font::{MonoFont, MonoTextStyle},
    pixelcolor::BinaryColor,
    prelude::*,
    text::{Baseline, Text},
};

/// Clears the display and writes `text` in white on black, starting at the top left.
///
/// Lines wrap between words.
///
/// # Errors
/// Returns an error if the display fails.
pub fn write<D>(display: &mut D, font: &MonoFont<'_>, text: impl fmt::Display) -> fmt::Result
where
    D: DrawTarget + OriginDimensions,
    D::Color: From<BinaryColor>,
{
    let black = BinaryColor::Off.into();
    display.clear(black).map_err(|_| fmt::Error)?;
    let cursor = Point::zero();
    fmt::Write::write_fmt(
        &mut Page {
            display,
            font,
            cursor,
        },
        format_args!("{text}"),
    )
}

struct Page<'d, D> {
    display: &'d mut D,
    font: &'d MonoFont<'d>,
    cursor: Point,
}

impl<D> Page<'_, D>
where
    D: DrawTarget + OriginDimensions,
    D::Color: From<BinaryColor>,
{
    /// Writes a word. The word starts a new line if the current line has no space left for
    /// it.
    fn word(&mut self, word: &str) -> Result<(), D::Error> {
        let Size { width, height } = self.font.character_size;
        let white = BinaryColor::On.into();
        let style = MonoTextStyle::new(self.font, white);
        let length = word.trim_end_matches(' ').len() as i32 * width as i32;
        if self.cursor.x + length > self.display.size().width as i32 {
            self.cursor = Point::new(0, self.cursor.y + height as i32);
        }
        let text = Text::with_baseline(word, self.cursor, style, Baseline::Top);
        self.cursor = text.draw(self.display)?;
        Ok(())
    }
}

impl<D> fmt::Write for Page<'_, D>
where
    D: DrawTarget + OriginDimensions,
    D::Color: From<BinaryColor>,
{
    fn write_str(&mut self, text: &str) -> fmt::Result {
        for word in text.split_inclusive(' ') {
            self.word(word).map_err(|_| fmt::Error)?;
        }
        Ok(())
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use embedded_graphics::mock_display::MockDisplay;
    use embedded_graphics::mono_font::ascii::FONT_6X9;

    #[test]
    fn wraps_lines_between_words() -> fmt::Result {
        let (mut wrapped, mut expected) = (MockDisplay::new(), MockDisplay::new());
        for display in [&mut wrapped, &mut expected] {
            display.set_allow_overdraw(true);
        }
        // The mock display is 64 pixels wide, so a line holds ten characters.
        write(&mut wrapped, &FONT_6X9, format_args!("no scene {}", 123))?;
        let Ok(()) = expected.clear(BinaryColor::Off);
        let style = MonoTextStyle::new(&FONT_6X9, BinaryColor::On);
        for (y, line) in [(0, "no scene "), (9, "123")] {
            let at = Point::new(0, y);
            let Ok(_) = Text::with_baseline(line, at, style, Baseline::Top).draw(&mut expected);
        }
        wrapped.assert_eq(&expected);
        Ok(())
    }
}
