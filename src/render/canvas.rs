//! Converts traced pixels to display colors and sends them to a `DrawTarget`.

use core::iter;

use embedded_graphics_core::Pixel;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{Point, Size};
use embedded_graphics_core::primitives::{PointsIter, Rectangle};

use crate::math::{Color, Radiance};
use crate::render::bounds::Bounds;
use crate::render::progress::RenderProgress;
use crate::render::row_span::RowSpan;
use crate::render::scanline::{TracedPixel, TracedPixels};
use crate::render::{DisplayColor, Output};

/// A display on which a picture is drawn at a position.
///
/// If `TRANSPARENT` is true, only the pixels whose camera ray hits an object are drawn. Pixels are
/// dithered by their position in the picture, so the picture looks the same at every position.
pub(crate) struct Canvas<'d, D, const TRANSPARENT: bool> {
    target: &'d mut D,
    /// Position of the top left pixel of the picture on the display.
    origin: Point,
    output: Output,
}

impl<'d, D, const TRANSPARENT: bool> Canvas<'d, D, TRANSPARENT>
where
    D: DrawTarget<Color: DisplayColor>,
{
    pub(crate) fn new(target: &'d mut D, origin: Point, output: Output) -> Self {
        Self {
            target,
            origin,
            output,
        }
    }

    /// Draws a row of single pixels, without gaps, by one call of `fill_contiguous`. A transparent
    /// picture needs one call for each run of pixels whose rays hit an object.
    pub(crate) fn fill_line(
        &mut self,
        row: &RowSpan,
        pixels: impl TracedPixels,
    ) -> Result<(), D::Error> {
        if TRANSPARENT {
            return self.fill_runs(row, pixels);
        }
        let area = self.on_display(row.area(row.columns.from));
        self.target
            .fill_contiguous(&area, pixels.map(display_color(row, self.output)))
    }

    /// Draws each run of pixels whose rays hit an object by one call of `fill_contiguous`. The area
    /// of the call extends to the end of the row, because the end of the run is not known at its
    /// start.
    fn fill_runs(&mut self, row: &RowSpan, mut pixels: impl TracedPixels) -> Result<(), D::Error> {
        while let Some(first) = next_hit(&mut pixels) {
            let color = display_color(row, self.output);
            let rest = iter::from_fn(|| {
                let pixel = pixels.next()?;
                (!pixels.take_miss()).then_some(pixel)
            });
            let area = self.on_display(row.area(first.0));
            let run = iter::once(first).chain(rest.fuse());
            self.target.fill_contiguous(&area, run.map(color))?;
        }
        Ok(())
    }

    /// Draws every other pixel of a row by one call of `draw_iter`.
    pub(crate) fn draw_sparse(
        &mut self,
        row: &RowSpan,
        mut pixels: impl TracedPixels,
    ) -> Result<(), D::Error> {
        let (color, origin) = (display_color(row, self.output), self.origin);
        let pixel = |pixel: TracedPixel| Pixel(shifted(row.point(pixel.0), origin), color(pixel));
        if TRANSPARENT {
            let hits = iter::from_fn(|| next_hit(&mut pixels));
            return self.target.draw_iter(hits.map(pixel));
        }
        self.target.draw_iter(pixels.map(pixel))
    }

    /// Draws a row of blocks. Each block is drawn by one call of `fill_contiguous`. After each
    /// block, `progress` advances by one. In a transparent picture, only the top left pixel of a
    /// block is drawn, because no later pass could clear the other pixels.
    ///
    /// Each pixel of a block is dithered at its own position, so the pixels of a block can have
    /// different colors.
    pub(crate) fn fill_blocks(
        &mut self,
        progress: &mut RenderProgress,
        bounds: Bounds,
        row: &RowSpan,
        mut pixels: impl TracedPixels,
    ) -> Result<(), D::Error> {
        while let Some((x, color)) = pixels.next() {
            if !TRANSPARENT {
                self.fill_block(row.block_at(x), color)?;
            } else if !pixels.take_miss() {
                self.fill_block(Rectangle::new(row.point(x), Size::new(1, 1)), color)?;
            }
            progress.advance(bounds);
        }
        Ok(())
    }

    fn fill_block(&mut self, block: Rectangle, color: Color<Radiance>) -> Result<(), D::Error> {
        let output = self.output;
        let colors = block
            .points()
            .map(|at| DisplayColor::from_radiance(color, at, output));
        self.target.fill_contiguous(&self.on_display(block), colors)
    }

    /// Converts an area of the picture to coordinates of the display.
    fn on_display(&self, area: Rectangle) -> Rectangle {
        Rectangle::new(shifted(area.top_left, self.origin), area.size)
    }
}

/// Traces pixels until the ray of a pixel hits an object, and returns that pixel.
fn next_hit(pixels: &mut impl TracedPixels) -> Option<TracedPixel> {
    loop {
        let pixel = pixels.next()?;
        if !pixels.take_miss() {
            return Some(pixel);
        }
    }
}

/// Adds two points. Sums that overflow wrap around.
fn shifted(point: Point, by: Point) -> Point {
    Point::new(point.x.wrapping_add(by.x), point.y.wrapping_add(by.y))
}

/// Returns a function that converts the pixels of a row to display colors.
fn display_color<C: DisplayColor>(
    row: &RowSpan,
    output: Output,
) -> impl Fn(TracedPixel) -> C + use<C> {
    let y = row.y as i32;
    move |(x, color)| C::from_radiance(color, Point::new(x as i32, y), output)
}
