//! Pixels to a display.

use embedded_graphics_core::Pixel as Dot;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{Point, Size};
use embedded_graphics_core::primitives::{PointsIter, Rectangle};

use super::Renderer;
use crate::math::{Color, Radiance};
use crate::observer::{Observer, Pair, Rays};
use crate::render::progress::{RenderProgress, RowSpan, Step};
use crate::render::scanline::PixelIter;
use crate::render::{DisplayColor, Output};

impl<O: Observer> Renderer<'_, O> {
    /// Draws the whole picture, top to bottom.
    ///
    /// # Errors
    /// The display's own, at once.
    pub fn draw<D>(&mut self, target: &mut D) -> Result<(), D::Error>
    where
        D: DrawTarget<Color: DisplayColor>,
    {
        let mut drawing = RenderProgress::scanlines(Rectangle::new(Point::zero(), self.size()));
        self.step(&mut drawing, Step::Pass, target)
    }

    /// Draws line `y` by one call of `fill_contiguous`.
    ///
    /// # Errors
    /// The display's own.
    pub fn draw_line<D>(&mut self, y: u32, target: &mut D) -> Result<(), D::Error>
    where
        D: DrawTarget<Color: DisplayColor>,
    {
        let row = RowSpan::line(y, self.view.columns());
        let output = self.output;
        fill_line(&row, self.pixels(y), output, target)
    }

    /// Draws on, as far as told; does nothing if the drawing is complete.
    ///
    /// A block is one call of `fill_contiguous`, and so is a line or the rest of
    /// one; where each second pixel of a line is new, those are one call of
    /// `draw_iter`. A step that ends within a line by its budget of rays ends the
    /// colors of that call early.
    ///
    /// This is inlined, so that a step known at compile time brings only its own
    /// code: [`Step::Rays`] has a copy of the ray tracer of its own, 10 KB of
    /// flash, which takes 3 % more instructions for counting.
    ///
    /// # Errors
    /// The display's own, at once. The drawing is then where the last call that
    /// succeeded took it. The next step repeats the call that failed, of which the display
    /// may have shown some pixels before, and no other; in the end the picture is the same.
    #[inline]
    pub fn step<D>(
        &mut self,
        drawing: &mut RenderProgress,
        step: Step,
        target: &mut D,
    ) -> Result<(), D::Error>
    where
        D: DrawTarget<Color: DisplayColor>,
    {
        match step {
            Step::Line => self.step_line(drawing, target),
            Step::Pass => self.step_pass(drawing, target),
            Step::Rays(budget) => self.step_rays(drawing, budget, target),
        }
    }

    fn step_line<D>(&mut self, drawing: &mut RenderProgress, target: &mut D) -> Result<(), D::Error>
    where
        D: DrawTarget<Color: DisplayColor>,
    {
        let size = self.size();
        let Some(row) = drawing.row(size) else {
            return Ok(());
        };
        let output = self.output;
        let (raster, observer) = (&mut self.raster, &mut self.observer);
        let pixels = raster.pixels(&self.view, row.y, row.columns, observer);
        if row.block > 1 {
            return fill_blocks(drawing, size, &row, pixels, output, target);
        }
        match row.is_whole() {
            true => fill_line(&row, pixels, output, target),
            false => draw_dots(&row, pixels, output, target),
        }?;
        drawing.finish_row(size);
        Ok(())
    }

    fn step_pass<D>(&mut self, drawing: &mut RenderProgress, target: &mut D) -> Result<(), D::Error>
    where
        D: DrawTarget<Color: DisplayColor>,
    {
        let pass = drawing.block();
        while drawing.block() == pass && !drawing.is_complete() {
            self.step_line(drawing, target)?;
        }
        Ok(())
    }

    fn step_rays<D>(
        &mut self,
        drawing: &mut RenderProgress,
        budget: u32,
        target: &mut D,
    ) -> Result<(), D::Error>
    where
        D: DrawTarget<Color: DisplayColor>,
    {
        let size = self.size();
        let output = self.output;
        let mut rays = Rays::default();
        while rays.0 < budget
            && let Some(row) = drawing.row(size)
        {
            let (raster, observer) = (&mut self.raster, &mut self.observer);
            let mut both = Pair(&mut rays, observer);
            let mut within = WithinBudget {
                pixels: raster.pixels(&self.view, row.y, row.columns, &mut both),
                budget,
                given: 0,
                is_spent: false,
            };
            if row.block > 1 {
                fill_blocks(drawing, size, &row, within, output, target)?;
                continue;
            }
            match row.is_whole() {
                true => fill_line(&row, &mut within, output, target),
                false => draw_dots(&row, &mut within, output, target),
            }?;
            match within.is_spent {
                true => drawing.advance(within.given, size),
                // What a display does not ask for it need not show.
                false => drawing.finish_row(size),
            }
        }
        Ok(())
    }
}

/// Fills blocks, one by one.
fn fill_blocks<D>(
    drawing: &mut RenderProgress,
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
        target.fill_contiguous(
            &block,
            block
                .points()
                .map(|at| DisplayColor::from_radiance(color, at, output)),
        )?;
        drawing.advance(1, size);
    }
    Ok(())
}

/// Fills a line, or the rest of one.
pub(crate) fn fill_line<D>(
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

/// Draws each second pixel of a line.
fn draw_dots<D>(
    row: &RowSpan,
    pixels: impl Iterator<Item = (u32, Color<Radiance>)>,
    output: Output,
    target: &mut D,
) -> Result<(), D::Error>
where
    D: DrawTarget<Color: DisplayColor>,
{
    let dots = pixels.map(|(x, color)| (row.point(x), color));
    target
        .draw_iter(dots.map(|(at, color)| Dot(at, DisplayColor::from_radiance(color, at, output))))
}

/// Pixels, until a budget of rays is spent.
struct WithinBudget<'r, 'o, O> {
    pixels: PixelIter<'r, Pair<'o, Rays, O>>,
    budget: u32,
    /// How many pixels there were.
    given: u32,
    /// Whether the budget was spent before the pixels were.
    is_spent: bool,
}

impl<O: Observer> Iterator for WithinBudget<'_, '_, O> {
    type Item = (u32, Color<Radiance>);

    #[inline(always)]
    fn next(&mut self) -> Option<Self::Item> {
        self.is_spent = self.pixels.observer.0.0 >= self.budget;
        if self.is_spent {
            return None;
        }
        self.given += 1;
        self.pixels.next()
    }
}
