//! Camera rays, scanlines, and output to a `DrawTarget`.
//!
//! A [`Renderer`] works line by line. It generates the camera rays of a scanline, excludes the
//! objects that the scanline cannot show, traces the rays and sends the pixels to the display. If
//! drawing is split into steps, [`RenderProgress`] records which pixels have been drawn.
//! [`AntialiasedRenderer`] smooths edges, [`DirtyLines`] skips unchanged pixels, and [`Output`]
//! selects the dithering and the transfer function.

#[cfg(feature = "antialiasing")]
mod antialias;
mod bounds;
pub(crate) mod camera_rays;
mod canvas;
mod column_range;
mod dirty_lines;
mod display_color;
mod output;
mod picture;
mod progress;
mod renderer;
mod row_span;
mod scanline;
mod scanline_culler;
mod scanline_methods;
mod scanline_plane;
mod scanline_rays;
#[cfg(test)]
mod tests;

#[cfg(feature = "antialiasing")]
pub use antialias::{
    AaSample, AntialiasError, AntialiasedPicture, AntialiasedRenderer, SampleCount,
};
pub use dirty_lines::DirtyLines;
pub use display_color::DisplayColor;
pub use output::{Dither, Output, Transfer};
pub use picture::Picture;
pub use progress::{RenderProgress, Step};
pub use renderer::Renderer;
