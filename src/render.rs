//! From rays to pixels, and from pixels to a `DrawTarget`.

mod antialias;
pub(crate) mod camera_rays;
mod dirty_lines;
mod display_color;
mod output;
mod progress;
mod renderer;
mod scanline;
mod scanline_culler;

pub use antialias::{AaSample, AntialiasError, AntialiasedRenderer, SampleCount};
pub use dirty_lines::DirtyLines;
pub use display_color::DisplayColor;
pub use output::{Dither, Output, Transfer};
pub use progress::{RenderProgress, Step};
pub use renderer::Renderer;
