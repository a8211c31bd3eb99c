#![no_std]
//! Text on a display, for what firmware has to say when it cannot draw.

use core::fmt;

use embedded_graphics::{
    mono_font::{MonoFont, MonoTextStyle},
    pixelcolor::BinaryColor,
    prelude::*,
    text::{Baseline, Text},
};

/// Clears a display and writes on it, white on black: from the top, broken
/// between words.
///
/// # Errors
/// That the display failed.
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
    fn lines_are_broken_between_words() -> fmt::Result {
        let (mut broken, mut lines) = (MockDisplay::new(), MockDisplay::new());
        for display in [&mut broken, &mut lines] {
            display.set_allow_overdraw(true);
        }
        // Ten characters a line.
        write(&mut broken, &FONT_6X9, format_args!("no scene {}", 123))?;
        let Ok(()) = lines.clear(BinaryColor::Off);
        let style = MonoTextStyle::new(&FONT_6X9, BinaryColor::On);
        for (y, line) in [(0, "no scene "), (9, "123")] {
            let at = Point::new(0, y);
            let Ok(_) = Text::with_baseline(line, at, style, Baseline::Top).draw(&mut lines);
        }
        broken.assert_eq(&lines);
        Ok(())
    }
}
