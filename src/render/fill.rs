//! Conversion of traced pixels to display colors and calls of a `DrawTarget`.

use embedded_graphics_core::Pixel;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::Size;
use embedded_graphics_core::primitives::PointsIter;

use crate::math::{Color, Radiance};
use crate::render::progress::RenderProgress;
use crate::render::row_span::RowSpan;
use crate::render::{DisplayColor, Output};

/// Draws the single pixels of a row by one call of `fill_contiguous`.
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

/// Draws the blocks of a row by one call of `fill_contiguous` each, and advances `progress` after
/// each of them.
///
/// Each pixel of a block is dithered at its own position, so the colors within a block can
/// differ.
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
        progress.advance(1, size);
    }
    Ok(())
}
