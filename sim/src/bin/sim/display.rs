//! Displays that are in use: what a picture looks like on each.

mod look;

use clap::ValueEnum;
use embedded_graphics::geometry::Size;
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics_simulator::BinaryColorTheme;
use whitted_sim::scene_file;

use crate::args::Format;

/// A display, as far as its picture is concerned.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Display {
    pub(crate) name: &'static str,
    pub(crate) size: Size,
    pub(crate) format: Format,
    controller: &'static str,
    note: &'static str,
    /// Whether only the circle within the size is there.
    is_round: bool,
    /// What both colors of a display of one bit look like.
    theme: BinaryColorTheme,
}

/// White paper and black ink, as they are in a room.
const PAPER: BinaryColorTheme = BinaryColorTheme::Custom {
    color_off: Rgb888::new(0x2b, 0x2a, 0x2c),
    color_on: Rgb888::new(0xe2, 0xe0, 0xd8),
};

/// The presets, from small to large.
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
    /// One that shows the colors as they are.
    pub(crate) const fn plain(size: Size, format: Format) -> Self {
        display("plain", (size.width, size.height), format, "", "")
    }

    /// The preset of this name.
    pub(crate) fn named(name: &str) -> Result<Self, String> {
        let names = || DISPLAYS.iter().map(|display| display.name);
        let found = DISPLAYS.iter().find(|display| display.name == name);
        found
            .copied()
            .ok_or_else(|| match scene_file::nearest(name, names()) {
                Some(name) => format!("did you mean `{name}`? `cargo sim displays` lists them"),
                None => "`cargo sim displays` lists them".to_owned(),
            })
    }
}

/// What a format is called on the command line.
pub(crate) fn format_name(format: Format) -> String {
    let value = format.to_possible_value();
    value.map_or_else(String::new, |value| value.get_name().to_owned())
}

/// Prints the presets.
pub(crate) fn list() {
    for display in DISPLAYS {
        let Size { width, height } = display.size;
        println!(
            "{:8} {:8} {:7} {:8} {}",
            display.name,
            format!("{width}x{height}"),
            format_name(display.format),
            display.controller,
            display.note
        );
    }
}
