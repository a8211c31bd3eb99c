//! Command-line options that several commands share. They set the picture size, the limits of the
//! ray tree, the display format, and the order of drawing.

use clap::{ValueEnum, value_parser};
use embedded_graphics::geometry::Size;
use whitted::Real;
use whitted::render::SampleCount;

use super::parse::{real, size};
use crate::display::Display;
use crate::format::Format;

/// Size of the picture and limits of the ray tree.
#[derive(Clone, Copy, clap::Args)]
pub(crate) struct Quality {
    /// Width and height in pixels.
    #[arg(long, value_name = "WxH", default_value = "320x240", value_parser = size)]
    pub(crate) size: Size,
    /// Generations of reflected and transmitted rays, 0 to 32 [default: the scene's].
    #[arg(long, value_name = "N", value_parser = value_parser!(u8).range(0..=32))]
    pub(crate) max_depth: Option<u8>,
    /// Weight below which a ray is not traced, 0 to 1 [default: the scene's].
    #[arg(long, value_name = "X", value_parser = real, allow_negative_numbers = true)]
    pub(crate) min_weight: Option<Real>,
}

/// Options for converting linear colors to a display's values.
#[derive(Clone, Copy, Debug, Default, clap::Args)]
pub(crate) struct DisplayOptions {
    /// Color format of the display.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
    /// Dithering of GIFs and of formats with fewer than 8 bits per channel.
    #[arg(long, value_enum, default_value_t)]
    dither: Dither,
    /// Encoding of linear light in the display's values [default: the scene's].
    #[arg(long, value_enum)]
    transfer: Option<Transfer>,
    /// Simulate the size, format and colors of a display. `sim displays` lists the displays.
    #[arg(long, value_name = "NAME", value_parser = Display::named)]
    #[arg(conflicts_with_all = ["size", "format"])]
    display: Option<Display>,
}

impl DisplayOptions {
    /// Returns the display. It is a plain display of the given size if the user names no display.
    pub(crate) fn display(self, size: Size) -> Display {
        let plain = || Display::plain(size, self.format);
        self.display.unwrap_or_else(plain)
    }

    /// Returns the transfer function, or `None` for that of the scene.
    pub(crate) fn transfer(self) -> Option<whitted::render::Transfer> {
        self.transfer.map(|transfer| match transfer {
            Transfer::Linear => whitted::render::Transfer::Linear,
            Transfer::Srgb => whitted::render::Transfer::Srgb,
        })
    }

    /// Returns the dithering.
    pub(crate) fn dither(self) -> whitted::render::Dither {
        match self.dither {
            Dither::On => whitted::render::Dither::Ordered,
            Dither::Off => whitted::render::Dither::Off,
        }
    }
}

/// Options for the order of drawing, the number of passes, and antialiasing.
#[derive(Clone, Copy, Debug, clap::Args)]
pub(crate) struct Passes {
    /// Order in which the display receives its pixels.
    #[arg(long, value_enum, default_value_t, conflicts_with = "antialias")]
    pub(crate) order: Order,
    /// Stop after N passes. Progressive order has five passes, and scanline order has one.
    #[arg(long = "passes", value_name = "N", default_value_t = Self::ALL, conflicts_with = "antialias")]
    #[arg(value_parser = value_parser!(u8).range(1..=5))]
    pub(crate) limit: u8,
    #[command(flatten)]
    pub(crate) edges: Edges,
}

/// Option for the antialiasing of edges.
#[derive(Clone, Copy, Debug, Default, clap::Args)]
pub(crate) struct Edges {
    /// Smooth edges: trace N more rays through each pixel that differs from a neighbor.
    #[arg(long, value_enum, value_name = "N")]
    antialias: Option<Antialias>,
}

impl Edges {
    /// Returns the number of additional rays for a pixel at an edge, or `None` without
    /// antialiasing.
    pub(crate) fn samples(self) -> Option<SampleCount> {
        self.antialias.map(Into::into)
    }
}

impl Passes {
    const ALL: u8 = 5;

    /// Each pass draws square blocks. Returns the side of the blocks of each pass, in pixels.
    pub(crate) fn blocks(&self) -> &'static [u32] {
        let blocks: &[u32] = match self.order {
            Order::Scanlines => &[1],
            Order::Progressive => &[16, 8, 4, 2, 1],
        };
        &blocks[..blocks.len().min(self.limit.into())]
    }
}

impl Default for Passes {
    fn default() -> Self {
        Self {
            order: Order::default(),
            limit: Self::ALL,
            edges: Edges::default(),
        }
    }
}

impl From<Edges> for Passes {
    fn from(edges: Edges) -> Self {
        Self {
            edges,
            ..Self::default()
        }
    }
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum Order {
    /// Line by line from the top
    #[default]
    Scanlines,
    /// In square blocks with sides of 16, then 8, 4, 2 and 1 pixels
    Progressive,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Antialias {
    #[value(name = "4")]
    Four,
    #[value(name = "16")]
    Sixteen,
}

impl From<Antialias> for SampleCount {
    fn from(antialias: Antialias) -> Self {
        match antialias {
            Antialias::Four => Self::Four,
            Antialias::Sixteen => Self::Sixteen,
        }
    }
}

#[derive(Clone, Copy, Debug, Default, ValueEnum)]
enum Dither {
    /// A pattern of the two nearest levels
    #[default]
    On,
    /// The nearest level
    Off,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Transfer {
    /// Values proportional to light
    Linear,
    /// Values encoded as sRGB
    Srgb,
}
