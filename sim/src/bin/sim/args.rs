use std::path::PathBuf;

use clap::{Parser, Subcommand, ValueEnum, value_parser};
use embedded_graphics::geometry::Size;
use whitted::Real;
use whitted::render::{Output, SampleCount};

use crate::display::Display;

/// Renders scenes on the host, with the arithmetic of the microcontroller.
///
/// Without a command: renders scenes/whitted.toml to whitted.png and shows it.
#[derive(Parser)]
#[command(name = "sim", version)]
pub(crate) struct Args {
    #[command(subcommand)]
    pub(crate) command: Option<Command>,
}

#[derive(Subcommand)]
pub(crate) enum Command {
    /// Render a scene to a PNG.
    Render(Render),
    /// Print how like two PNGs are: PSNR, and the share of pixels within 1/255.
    Compare {
        /// A PNG of 8 or 16 bits a channel, gray or RGB.
        a: PathBuf,
        /// Another of the same size.
        b: PathBuf,
    },
    /// Say whether a scene can be rendered, and what memory it takes.
    Check {
        /// A scene file, or a compiled scene.
        scene: PathBuf,
    },
    /// Render a scene that moves to an animated GIF or PNG, or to numbered PNGs.
    ///
    /// What moves stands in the scene's table `animation`; without one the camera orbits once.
    Animate(Animate),
    /// Write a scene in the compact form that microcontrollers decode.
    Compile {
        /// A scene file.
        scene: PathBuf,
        /// The file to write.
        #[arg(short, long, value_name = "FILE")]
        output: PathBuf,
    },
    /// Send a scene to a board by USB; it is shown until the board is reset.
    ///
    /// The board checks it first: a transfer that breaks off, or a scene that cannot be
    /// drawn, changes nothing.
    Send(Send),
    /// Print the tree of rays that a pixel's color comes from.
    ///
    /// A line is a ray: E from the eye, R reflected, T transmitted; what it met,
    /// the share of it that reaches the eye (weight), and the color of the place
    /// itself (local). S are the shadow rays between that place and the lights.
    Explain(Explain),
    /// Render scenes into a directory, with a page to look at them.
    Gallery(Gallery),
    /// List the displays that `render` and `view` know.
    Displays,
    /// Show scenes in a window, as displays show them (needs the feature `window`).
    View(View),
}

#[derive(clap::Args)]
pub(crate) struct Render {
    /// A scene file, a compiled scene, or the name of a scene in scenes/.
    pub(crate) scene: PathBuf,
    /// The PNG to write [default: named after the scene].
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) quality: Quality,
    #[command(flatten)]
    pub(crate) shown: Shown,
    #[command(flatten)]
    pub(crate) passes: Passes,
    /// Write linear colors, 16 bits a channel, in place of a display's.
    #[arg(long, conflicts_with_all = ["format", "dither", "transfer", "order", "most"])]
    pub(crate) linear16: bool,
    /// A display to show it on, with that one's size, pixels and colors: see `displays`.
    #[arg(long, value_name = "NAME", value_parser = Display::named)]
    #[arg(conflicts_with_all = ["size", "format", "linear16"])]
    pub(crate) display: Option<Display>,
    /// How many pixels of the PNG a display's pixel is wide and high.
    #[arg(
        long,
        value_name = "N",
        default_value_t = 1,
        conflicts_with = "linear16"
    )]
    #[arg(value_parser = value_parser!(u32).range(1..=16))]
    pub(crate) scale: u32,
    /// Print rays, intersection tests, time, what microcontrollers would take, and checksum.
    #[arg(long)]
    pub(crate) stats: bool,
}

#[derive(clap::Args)]
pub(crate) struct Animate {
    /// A scene file, or the name of a scene in scenes/.
    pub(crate) scene: PathBuf,
    /// A GIF, an APNG (FILE.apng or FILE.png), or a directory for numbered PNGs.
    #[arg(short, long, value_name = "FILE|DIR")]
    pub(crate) output: PathBuf,
    /// Frames a second [default: 20].
    #[arg(long, value_name = "N", value_parser = value_parser!(u16).range(1..=100))]
    pub(crate) fps: Option<u16>,
    /// How many frames [default: as many as the animation takes].
    #[arg(long, value_name = "N", value_parser = value_parser!(u16).range(1..))]
    pub(crate) frames: Option<u16>,
    #[command(flatten)]
    pub(crate) quality: Quality,
    #[command(flatten)]
    pub(crate) shown: Shown,
}

#[derive(clap::Args)]
pub(crate) struct Send {
    /// A scene file, a compiled scene, or the name of a scene in scenes/.
    pub(crate) scene: PathBuf,
    /// The board's serial port: /dev/ttyACM0, /dev/cu.usbmodem1101, COM3.
    #[arg(long)]
    pub(crate) port: Option<PathBuf>,
}

#[derive(clap::Args)]
pub(crate) struct Explain {
    /// A scene file, a compiled scene, or the name of a scene in scenes/.
    pub(crate) scene: PathBuf,
    /// The pixel's column, from 0 at the left.
    #[arg(allow_negative_numbers = true)]
    pub(crate) x: u32,
    /// The pixel's row, from 0 at the top.
    #[arg(allow_negative_numbers = true)]
    pub(crate) y: u32,
    #[command(flatten)]
    pub(crate) quality: Quality,
}

#[derive(clap::Args)]
pub(crate) struct Gallery {
    /// Scene files, compiled scenes, or names of scenes in scenes/ [default: all of scenes/].
    pub(crate) scenes: Vec<PathBuf>,
    /// The directory to write NAME.png, index.html and contact-sheet.png to.
    #[arg(short, long, value_name = "DIR")]
    pub(crate) output: PathBuf,
    /// Width and height of each picture in pixels.
    #[arg(long, value_name = "WxH", default_value = "640x480", value_parser = size)]
    pub(crate) size: Size,
}

#[derive(clap::Args)]
pub(crate) struct View {
    /// Scene files, compiled scenes, or names of scenes in scenes/ [default: all of scenes/].
    pub(crate) scenes: Vec<PathBuf>,
    /// The display to begin with, in place of a plain one of the size: see `displays`.
    #[arg(long, value_name = "NAME", value_parser = Display::named, conflicts_with = "size")]
    pub(crate) display: Option<Display>,
    #[command(flatten)]
    pub(crate) quality: Quality,
}

/// What a rendering costs.
#[derive(Clone, Copy, clap::Args)]
pub(crate) struct Quality {
    /// Width and height in pixels.
    #[arg(long, value_name = "WxH", default_value = "320x240", value_parser = size)]
    pub(crate) size: Size,
    /// Secondary generations of rays, 0 to 32, in place of the scene's.
    #[arg(long, value_name = "N", value_parser = value_parser!(u8).range(0..=32))]
    pub(crate) max_depth: Option<u8>,
    /// Weight below which a branch of rays ends, 0 to 1, in place of the scene's.
    #[arg(long, value_name = "X", value_parser = real, allow_negative_numbers = true)]
    pub(crate) min_weight: Option<Real>,
}

/// How a display shows a picture.
#[derive(Clone, Copy, Debug, Default, clap::Args)]
pub(crate) struct Shown {
    /// The display's pixels.
    #[arg(long, value_enum, default_value_t)]
    pub(crate) format: Format,
    /// What becomes of colors between two levels of fewer than 8 bits.
    #[arg(long, value_enum, default_value_t)]
    dither: Dither,
    /// From light to the display's values.
    #[arg(long, value_enum, default_value_t)]
    transfer: Transfer,
}

impl Shown {
    /// The same for the library.
    pub(crate) fn output(self) -> Output {
        Output {
            transfer: match self.transfer {
                Transfer::Linear => whitted::render::Transfer::Linear,
                Transfer::Srgb => whitted::render::Transfer::Srgb,
            },
            dither: match self.dither {
                Dither::On => whitted::render::Dither::Ordered,
                Dither::Off => whitted::render::Dither::Off,
            },
        }
    }
}

/// In which order a display gets its pixels, how many of them, and how good.
#[derive(Clone, Copy, Debug, clap::Args)]
pub(crate) struct Passes {
    /// In which order the display gets its pixels.
    #[arg(long, value_enum, default_value_t)]
    pub(crate) order: Order,
    /// Stop after so many passes: progressive order has five, scanlines have one.
    #[arg(long = "passes", value_name = "N", default_value_t = Self::ALL, value_parser = value_parser!(u8).range(1..=5))]
    pub(crate) most: u8,
    /// Smooth edges: this many more rays through pixels that differ from their neighbors.
    #[arg(long, value_enum, value_name = "N", conflicts_with_all = ["order", "most"])]
    antialias: Option<Antialias>,
}

impl Passes {
    const ALL: u8 = 5;

    /// How edges are smoothed.
    pub(crate) fn samples(&self) -> Option<SampleCount> {
        self.antialias.map(Into::into)
    }

    /// The sides of the blocks of each pass.
    pub(crate) fn blocks(&self) -> &'static [u32] {
        let blocks: &[u32] = match self.order {
            Order::Scanlines => &[1],
            Order::Progressive => &[16, 8, 4, 2, 1],
        };
        &blocks[..blocks.len().min(self.most.into())]
    }
}

impl Default for Passes {
    fn default() -> Self {
        Self {
            order: Order::default(),
            most: Self::ALL,
            antialias: None,
        }
    }
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum Order {
    /// Line by line, from the top.
    #[default]
    Scanlines,
    /// In blocks of 16 pixels a side, then 8, 4, 2 and 1.
    Progressive,
}

/// The color formats of displays. The order of channels changes no picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// 24 bits.
    #[default]
    Rgb888,
    /// 18 bits.
    Rgb666,
    /// 16 bits.
    Rgb565,
    /// 15 bits.
    Rgb555,
    /// 256 grays.
    Gray8,
    /// 16 grays.
    Gray4,
    /// 4 grays.
    Gray2,
    /// Black and white.
    #[value(alias = "bw")]
    Binary,
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
    /// A pattern of the level below and the level above.
    #[default]
    On,
    /// The nearest level.
    Off,
}

#[derive(Clone, Copy, Debug, Default, ValueEnum)]
enum Transfer {
    /// Values are linear light.
    #[default]
    Linear,
    /// Values are encoded as sRGB.
    Srgb,
}

/// The longest side of a picture.
const LONGEST: u32 = 8192;

fn size(text: &str) -> Result<Size, String> {
    let sides = text.split_once('x').map(|(w, h)| (w.parse(), h.parse()));
    let Some((Ok(width), Ok(height))) = sides else {
        return Err("write width and height, for example 320x240".to_owned());
    };
    let possible = 1..=LONGEST;
    if possible.contains(&width) && possible.contains(&height) {
        Ok(Size::new(width, height))
    } else {
        Err(format!("width and height must be from 1 to {LONGEST}"))
    }
}

fn real(text: &str) -> Result<Real, String> {
    text.parse()
        .map_err(|_| "write a number, for example 0.004".to_owned())
}
