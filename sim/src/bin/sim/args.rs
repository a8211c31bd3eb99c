//! Command line of the program.

mod parse;
mod picture;

use std::path::PathBuf;

use clap::{CommandFactory, FromArgMatches, Parser, Subcommand, ValueEnum, value_parser};
use embedded_graphics::geometry::Size;

use crate::display::Display;
use parse::size;
pub(crate) use picture::{DisplayOptions, Edges, Order, Passes, Quality};

/// Renders scenes on the host, with the same arithmetic as on microcontrollers.
///
/// Without a command, `sim` renders scenes/whitted.toml to whitted.png and shows it in the terminal.
#[derive(Parser)]
#[command(name = "sim", version)]
pub(crate) struct Args {
    #[command(subcommand)]
    pub(crate) command: Option<Command>,
}

impl Args {
    /// Parses the command line. If an option or the command is invalid, prints an error and exits.
    ///
    /// All options accept negative numbers, so that the error for such a number names the range of
    /// the option. By default, clap takes `-1` for an option and advises to write `-- -1`.
    pub(crate) fn from_command_line() -> Self {
        let command = Self::command().mut_subcommands(|command| {
            command.mut_args(|arg| match arg.get_id().as_str() {
                "size" => arg.allow_hyphen_values(true),
                _ if arg.get_action().takes_values() => arg.allow_negative_numbers(true),
                _ => arg,
            })
        });
        Self::from_arg_matches(&command.get_matches()).unwrap_or_else(|error| error.exit())
    }
}

#[derive(Subcommand)]
pub(crate) enum Command {
    /// Render a scene to a PNG.
    Render(Render),
    /// Compare two PNGs: print the PSNR and the share of pixels that differ by at most 1/255.
    Compare {
        /// A gray or RGB PNG with 8 or 16 bits per channel.
        a: PathBuf,
        /// A PNG of the same size.
        b: PathBuf,
    },
    /// Check that a scene can be rendered and animated, and print its memory use.
    ///
    /// Prints warnings about scenes that look black or odd: scenes without a light, a light or the
    /// eye inside an opaque object, materials that have no effect.
    Check {
        /// A scene file, or a compiled scene.
        scene: PathBuf,
    },
    /// Write a scene file with comments, to start a scene of your own.
    New {
        /// File to write, NAME or NAME.toml. An existing file is not changed.
        name: PathBuf,
    },
    /// Render an animated scene to a GIF, an animated PNG, or numbered PNGs.
    ///
    /// The table `animation` of the scene file has the keyframes. Without this table, the camera
    /// makes one orbit around the scene.
    Animate(Animate),
    /// Compile a scene to the binary format that microcontrollers decode.
    Compile {
        /// A scene file, or `-` for stdin.
        scene: PathBuf,
        /// File to write, FILE.scene or FILE.bin, or `-` for stdout.
        #[arg(short, long, value_name = "FILE")]
        output: PathBuf,
    },
    /// Send a scene to a board by USB. The board shows the scene until its next reset.
    ///
    /// The board checks the scene before it draws. If the transfer is incomplete or the scene
    /// cannot be drawn, the board keeps its current scene.
    Send(Send),
    /// Print the tree of rays behind a pixel's color.
    ///
    /// Each line of the tree shows a ray. The line starts with the kind of the ray: C for camera, R
    /// for reflected, T for transmitted, S for shadow. The object that the ray hits comes next.
    /// `weight` is the share of the object's color that reaches the camera. `local` is the color of
    /// the surface without reflected and transmitted light. A shadow ray's line shows a light, and
    /// how much of this light reaches the surface.
    Explain(Explain),
    /// Render scenes to PNGs in a directory, and write an HTML page that shows the PNGs.
    Gallery(Gallery),
    /// List the displays that `render`, `animate`, `gallery` and `view` simulate.
    Displays,
    /// Show scenes in a window, as on a display (needs the feature `window`).
    View(View),
}

#[derive(clap::Args)]
pub(crate) struct Render {
    /// A scene file, a compiled scene, the name of a scene in scenes/, or `-` for stdin.
    pub(crate) scene: PathBuf,
    /// PNG to write, or `-` for stdout [default: named after the scene].
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) quality: Quality,
    #[command(flatten)]
    pub(crate) display_options: DisplayOptions,
    #[command(flatten)]
    pub(crate) passes: Passes,
    /// Write linear colors with 16 bits per channel, instead of a display's colors.
    #[arg(long, conflicts_with_all = ["format", "dither", "transfer", "display", "order", "limit"])]
    pub(crate) linear16: bool,
    /// Width and height of a display pixel in the PNG, in pixels.
    #[arg(
        long,
        value_name = "N",
        default_value_t = 1,
        conflicts_with = "linear16"
    )]
    #[arg(value_parser = value_parser!(u32).range(1..=16))]
    pub(crate) scale: u32,
    /// Print numbers of rays and intersection tests, the time, estimated times on microcontrollers,
    /// and the checksum.
    #[arg(long)]
    pub(crate) stats: bool,
}

#[derive(clap::Args)]
pub(crate) struct Animate {
    /// A scene file, the name of a scene in scenes/, or `-` for stdin.
    pub(crate) scene: PathBuf,
    /// File to write, a GIF (FILE.gif) or an APNG (FILE.apng or FILE.png), a directory for numbered
    /// PNGs, or `-` for stdout.
    #[arg(short, long, value_name = "FILE|DIR")]
    pub(crate) output: PathBuf,
    /// File format for stdout and pipes [default: gif]. The names of files show their format.
    #[arg(long, value_enum)]
    pub(crate) container: Option<Container>,
    /// Frames per second, at most 50 in a GIF [default: 20].
    #[arg(long, value_name = "N", value_parser = value_parser!(u16).range(1..=100))]
    pub(crate) fps: Option<u16>,
    /// Number of frames [default: the duration times the frame rate].
    #[arg(long, value_name = "N", value_parser = value_parser!(u16).range(1..))]
    pub(crate) frames: Option<u16>,
    #[command(flatten)]
    pub(crate) quality: Quality,
    #[command(flatten)]
    pub(crate) display_options: DisplayOptions,
    #[command(flatten)]
    pub(crate) edges: Edges,
}

/// File formats of animations.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Container {
    /// At most 256 colors and 50 frames per second
    Gif,
    /// An animated PNG with all colors
    Apng,
}

#[derive(clap::Args)]
pub(crate) struct Send {
    /// A scene file, a compiled scene, or the name of a scene in scenes/.
    pub(crate) scene: PathBuf,
    /// Serial port of the board: /dev/ttyACM0, /dev/cu.usbmodem1101, COM3.
    #[arg(long)]
    pub(crate) port: Option<PathBuf>,
}

#[derive(clap::Args)]
pub(crate) struct Explain {
    /// A scene file, a compiled scene, or the name of a scene in scenes/.
    pub(crate) scene: PathBuf,
    /// Column of the pixel, from 0 at the left.
    #[arg(allow_negative_numbers = true)]
    pub(crate) x: u32,
    /// Row of the pixel, from 0 at the top.
    #[arg(allow_negative_numbers = true)]
    pub(crate) y: u32,
    #[command(flatten)]
    pub(crate) quality: Quality,
}

#[derive(clap::Args)]
pub(crate) struct Gallery {
    /// Scene files, compiled scenes, or names of scenes in scenes/ [default: all of scenes/].
    pub(crate) scenes: Vec<PathBuf>,
    /// Directory for NAME.png, index.html and contact-sheet.png.
    #[arg(short, long, value_name = "DIR")]
    pub(crate) output: PathBuf,
    /// Width and height of each picture in pixels.
    #[arg(long, value_name = "WxH", default_value = "640x480", value_parser = size)]
    pub(crate) size: Size,
    #[command(flatten)]
    pub(crate) display_options: DisplayOptions,
    #[command(flatten)]
    pub(crate) edges: Edges,
}

#[derive(clap::Args)]
pub(crate) struct View {
    /// Scene files, compiled scenes, or names of scenes in scenes/ [default: all of scenes/].
    pub(crate) scenes: Vec<PathBuf>,
    /// Display to start with; `sim displays` lists them [default: a plain display of the size].
    #[arg(long, value_name = "NAME", value_parser = Display::named, conflicts_with = "size")]
    pub(crate) display: Option<Display>,
    #[command(flatten)]
    pub(crate) quality: Quality,
}
