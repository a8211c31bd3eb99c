//! Stepwise drawing.

use embedded_graphics_core::draw_target::DrawTarget;

use super::Renderer;
use crate::math::{Color, Radiance};
use crate::observer::{Observer, Pair, RayCounter};
use crate::render::DisplayColor;
use crate::render::fill::{draw_sparse, fill_blocks, fill_line};
use crate::render::progress::{RenderProgress, Step};
use crate::render::scanline::PixelIter;

impl<O: Observer> Renderer<'_, O> {
    /// Continues `progress` by one step; does nothing if it is complete.
    ///
    /// A line or the rest of a line is one call of `fill_contiguous`, and so is a block larger
    /// than a pixel. In a pass that traces every other pixel of a line, the line is one call of
    /// `draw_iter`. If [`Step::Rays`] ends within a line, its call gets fewer colors than its
    /// area has pixels.
    ///
    /// `step` is inlined, so a step that is known at compile time links only its own code.
    /// [`Step::Rays`] links a second copy of the ray tracer, 10 KB of flash, that counts rays and
    /// executes 3 % more instructions.
    ///
    /// # Errors
    /// The first error of the display, which ends the step. `progress` is then at the start of
    /// the failed call, of which the display may have shown some pixels. The next step repeats
    /// that call and no other, so the finished picture is the same.
    #[inline]
    pub fn step<D>(
        &mut self,
        progress: &mut RenderProgress,
        step: Step,
        target: &mut D,
    ) -> Result<(), D::Error>
    where
        D: DrawTarget<Color: DisplayColor>,
    {
        match step {
            Step::Line => self.step_line(progress, target),
            Step::Pass => self.step_pass(progress, target),
            Step::Rays(budget) => self.step_rays(progress, budget, target),
        }
    }

    fn step_line<D>(
        &mut self,
        progress: &mut RenderProgress,
        target: &mut D,
    ) -> Result<(), D::Error>
    where
        D: DrawTarget<Color: DisplayColor>,
    {
        let size = self.size();
        let Some(row) = progress.row(size) else {
            return Ok(());
        };
        let output = self.output;
        let (tracer, observer) = (&mut self.tracer, &mut self.observer);
        let pixels = tracer.pixels(&self.rays, row.y, row.columns, observer);
        if row.block > 1 {
            return fill_blocks(progress, size, &row, pixels, output, target);
        }
        match row.is_contiguous() {
            true => fill_line(&row, pixels, output, target),
            false => draw_sparse(&row, pixels, output, target),
        }?;
        progress.finish_row(size);
        Ok(())
    }

    fn step_pass<D>(
        &mut self,
        progress: &mut RenderProgress,
        target: &mut D,
    ) -> Result<(), D::Error>
    where
        D: DrawTarget<Color: DisplayColor>,
    {
        let pass = progress.block();
        while progress.block() == pass && !progress.is_complete() {
            self.step_line(progress, target)?;
        }
        Ok(())
    }

    fn step_rays<D>(
        &mut self,
        progress: &mut RenderProgress,
        budget: u32,
        target: &mut D,
    ) -> Result<(), D::Error>
    where
        D: DrawTarget<Color: DisplayColor>,
    {
        let size = self.size();
        let output = self.output;
        let mut counter = RayCounter::default();
        while counter.0 < budget
            && let Some(row) = progress.row(size)
        {
            let (tracer, observer) = (&mut self.tracer, &mut self.observer);
            let mut both = Pair(&mut counter, observer);
            let mut pixels = RayBudget {
                pixels: tracer.pixels(&self.rays, row.y, row.columns, &mut both),
                budget,
                yielded: 0,
                is_exhausted: false,
            };
            if row.block > 1 {
                fill_blocks(progress, size, &row, pixels, output, target)?;
                continue;
            }
            match row.is_contiguous() {
                true => fill_line(&row, &mut pixels, output, target),
                false => draw_sparse(&row, &mut pixels, output, target),
            }?;
            match pixels.is_exhausted {
                true => progress.advance(pixels.yielded, size),
                // A display that takes only some of the pixels has clipped the others.
                false => progress.finish_row(size),
            }
        }
        Ok(())
    }
}

/// Iterator over pixels that ends when a number of rays has been traced.
struct RayBudget<'r, 's, 'o, O> {
    pixels: PixelIter<'r, 's, Pair<'o, RayCounter, O>>,
    budget: u32,
    /// Number of pixels that the iterator has returned.
    yielded: u32,
    /// True if the budget ended before the pixels.
    is_exhausted: bool,
}

impl<O: Observer> Iterator for RayBudget<'_, '_, '_, O> {
    type Item = (u32, Color<Radiance>);

    #[inline(always)]
    fn next(&mut self) -> Option<Self::Item> {
        self.is_exhausted = self.pixels.tracer.observer.0.0 >= self.budget;
        if self.is_exhausted {
            return None;
        }
        self.yielded += 1;
        self.pixels.next()
    }
}
