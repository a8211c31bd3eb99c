//! Functions that convert traced pixels to display colors and send them to a `DrawTarget`.

use embedded_graphics_core::Pixel;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::Size;
use embedded_graphics_core::primitives::PointsIter;

use crate::math::{Color, Radiance};
use crate::render::progress::RenderProgress;
use crate::render::row_span::RowSpan;
use crate::render::{DisplayColor, Output};

/// Draws a row of single pixels, without gaps, by one call of `fill_contiguous`.
pub(super) fn fill_line<D>(
    row: &RowSpan,
    pixels: impl Iterator<Item = (u32, Color<Radiance>)>,
    output: Output,
    target: &mut D,
) -> Result<(), D::Error>
where
    D: DrawTarget<Color: DisplayColor>,
{
    let colors = pixels.map(|(x, color)| DisplayColor::from_radiance(color, row.point(x), output));
    target.fill_contiguous(&row.area(), colors)
}

/// Draws every other pixel of a row by one call of `draw_iter`.
pub(super) fn draw_sparse<D>(
    row: &RowSpan,
    pixels: impl Iterator<Item = (u32, Color<Radiance>)>,
    output: Output,
    target: &mut D,
) -> Result<(), D::Error>
where
    D: DrawTarget<Color: DisplayColor>,
{
    target.draw_iter(pixels.map(|(x, color)| {
        let at = row.point(x);
        Pixel(at, DisplayColor::from_radiance(color, at, output))
    }))
}

/// Draws a row of blocks. Each block is drawn by one call of `fill_contiguous`. After each
/// block, `progress` advances by one.
///
/// Each pixel of a block is dithered at its own position, so the pixels of a block can have
/// different colors.
pub(super) fn fill_blocks<D>(
    progress: &mut RenderProgress,
    size: Size,
    row: &RowSpan,
    pixels: impl Iterator<Item = (u32, Color<Radiance>)>,
    output: Output,
    target: &mut D,
) -> Result<(), D::Error>
where
    D: DrawTarget<Color: DisplayColor>,
{
    for (x, color) in pixels {
        let block = row.block_at(x);
        let colors = block
            .points()
            .map(|at| DisplayColor::from_radiance(color, at, output));
        target.fill_contiguous(&block, colors)?;
        progress.advance(size);
    }
    Ok(())
}
