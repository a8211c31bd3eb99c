//! Presets of common displays.

mod look;

use std::io::Write;

use embedded_graphics::geometry::Size;
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics_simulator::BinaryColorTheme;
use whitted_sim::scene_file;

use crate::console::Console;
use crate::format::Format;
use crate::outcome::Outcome;

/// Size, format and appearance of a display.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Display {
    pub(crate) name: &'static str,
    pub(crate) size: Size,
    pub(crate) format: Format,
    controller: &'static str,
    note: &'static str,
    /// True if the display is round. It then shows only the pixels inside a circle that touches the
    /// sides of the pixel area.
    is_round: bool,
    /// Colors of a one-bit display.
    theme: BinaryColorTheme,
}

/// Colors of e-paper in indoor light.
const PAPER: BinaryColorTheme = BinaryColorTheme::Custom {
    color_off: Rgb888::new(0x2b, 0x2a, 0x2c),
    color_on: Rgb888::new(0xe2, 0xe0, 0xd8),
};

/// Presets of displays, sorted by size.
pub(crate) const DISPLAYS: [Display; 7] = [
    Display {
        theme: BinaryColorTheme::OledBlue,
        ..display(
            "ssd1306",
            (128, 64),
            Format::Binary,
            "SSD1306",
            "0.96\" OLED, light blue",
        )
    },
    display(
        "ssd0323",
        (128, 64),
        Format::Gray4,
        "SSD0323",
        "OLED of the LM3S6965 board, 16 grays",
    ),
    display(
        "st7735",
        (160, 128),
        Format::Rgb565,
        "ST7735",
        "1.8\" TFT, landscape",
    ),
    Display {
        theme: PAPER,
        ..display(
            "epaper",
            (296, 128),
            Format::Binary,
            "SSD1680",
            "2.9\" e-paper, black on white",
        )
    },
    display(
        "st7789",
        (240, 240),
        Format::Rgb565,
        "ST7789",
        "1.3\" TFT, square",
    ),
    Display {
        is_round: true,
        ..display(
            "gc9a01",
            (240, 240),
            Format::Rgb565,
            "GC9A01",
            "1.28\" TFT, round: no corners",
        )
    },
    display(
        "ili9341",
        (320, 240),
        Format::Rgb565,
        "ILI9341",
        "2.4\" or larger TFT, landscape",
    ),
];

const fn display(
    name: &'static str,
    (width, height): (u32, u32),
    format: Format,
    controller: &'static str,
    note: &'static str,
) -> Display {
    Display {
        name,
        size: Size::new(width, height),
        format,
        controller,
        note,
        is_round: false,
        theme: BinaryColorTheme::Default,
    }
}

impl Display {
    /// Returns a rectangular display without a color theme.
    pub(crate) const fn plain(size: Size, format: Format) -> Self {
        display("plain", (size.width, size.height), format, "", "")
    }

    /// Returns the same display with another size.
    pub(crate) const fn resized(self, size: Size) -> Self {
        Self { size, ..self }
    }

    /// Returns the preset with a name.
    pub(crate) fn named(name: &str) -> Result<Self, String> {
        let names = || DISPLAYS.iter().map(|display| display.name);
        let found = DISPLAYS.iter().find(|display| display.name == name);
        found
            .copied()
            .ok_or_else(|| match scene_file::nearest(name, names()) {
                Some(name) => {
                    format!("did you mean `{name}`? `cargo sim displays` lists all displays")
                }
                None => "`cargo sim displays` lists all displays".to_owned(),
            })
    }
}

/// Prints the presets, one per line.
pub(crate) fn list() -> Outcome {
    for display in DISPLAYS {
        let Size { width, height } = display.size;
        writeln!(
            Console::Stdout,
            "{:8} {:8} {:7} {:8} {}",
            display.name,
            format!("{width}x{height}"),
            display.format.name(),
            display.controller,
            display.note
        )?;
    }
    Ok(())
}
