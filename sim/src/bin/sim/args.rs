use std::path::PathBuf;

use clap::{Parser, Subcommand, ValueEnum, value_parser};
use embedded_graphics::geometry::Size;
use whitted::Real;

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
    /// Write a scene in the compact form that microcontrollers decode.
    Compile {
        /// A scene file.
        scene: PathBuf,
        /// The file to write.
        #[arg(short, long, value_name = "FILE")]
        output: PathBuf,
    },
    /// Print the tree of rays that a pixel's color comes from.
    ///
    /// A line is a ray: E from the eye, R reflected, T transmitted; what it met,
    /// the share of it that reaches the eye (weight), and the color of the place
    /// itself (local). S are the shadow rays between that place and the lights.
    Explain(Explain),
    /// Render scenes into a directory, with a page to look at them.
    Gallery(Gallery),
    /// Show a scene in a window (needs the feature `window`).
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
    /// The display's pixels.
    #[arg(long, value_enum, default_value_t)]
    pub(crate) format: Format,
    #[command(flatten)]
    pub(crate) passes: Passes,
    /// Write linear colors, 16 bits a channel, in place of a display's.
    #[arg(long, conflicts_with_all = ["format", "order", "most"])]
    pub(crate) linear16: bool,
    /// Print rays, intersection tests, time, what microcontrollers would take, and checksum.
    #[arg(long)]
    pub(crate) stats: bool,
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
    /// A scene file, a compiled scene, or the name of a scene in scenes/.
    #[arg(default_value = "whitted")]
    pub(crate) scene: PathBuf,
    #[command(flatten)]
    pub(crate) quality: Quality,
}

/// What a rendering costs.
#[derive(clap::Args)]
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

/// In which order a display gets its pixels, and how many of them.
#[derive(Clone, Copy, Debug, clap::Args)]
pub(crate) struct Passes {
    /// In which order the display gets its pixels.
    #[arg(long, value_enum, default_value_t)]
    pub(crate) order: Order,
    /// Stop after so many passes: progressive order has five, scanlines have one.
    #[arg(long = "passes", value_name = "N", default_value_t = Self::ALL, value_parser = value_parser!(u8).range(1..=5))]
    pub(crate) most: u8,
}

impl Passes {
    const ALL: u8 = 5;
}

impl Default for Passes {
    fn default() -> Self {
        Self {
            order: Order::default(),
            most: Self::ALL,
        }
    }
}

#[derive(Clone, Copy, Debug, Default, ValueEnum)]
pub(crate) enum Order {
    /// Line by line, from the top.
    #[default]
    Scanlines,
    /// In blocks of 16 pixels a side, then 8, 4, 2 and 1.
    Progressive,
}

/// The color formats of displays.
#[derive(Clone, Copy, Debug, Default, ValueEnum)]
pub(crate) enum Format {
    /// 24 bits.
    #[default]
    Rgb888,
    /// 16 bits.
    Rgb565,
    /// 256 grays.
    Gray8,
    /// 16 grays.
    Gray4,
    /// 4 grays.
    Gray2,
    /// Black and white.
    Bw,
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
