//! Drawing of a picture in steps of limited work.

use embedded_graphics_core::draw_target::DrawTarget;

use super::Renderer;
use crate::math::{Color, Radiance};
use crate::observer::{Observer, Pair, RayCounter};
use crate::render::DisplayColor;
use crate::render::fill::{draw_sparse, fill_blocks, fill_line};
use crate::render::progress::{RenderProgress, Step};
use crate::render::scanline::PixelIter;

impl<O: Observer> Renderer<'_, O> {
    /// Draws the next step of a picture and advances `progress`. Does nothing if the picture is
    /// complete.
    ///
    /// Each block larger than one pixel is drawn by one call of `fill_contiguous`. Single pixels
    /// are drawn line by line: one call of `fill_contiguous` draws a line or the rest of a line. If
    /// a pass traces only every other pixel of a line, one call of `draw_iter` draws these pixels
    /// instead. If a [`Step::Rays`] step ends within a line, the call for this line receives fewer
    /// colors than the line has pixels.
    ///
    /// `step` is inlined. If the kind of step is known at compile time, the program contains only
    /// the code for that kind. [`Step::Rays`] needs a second copy of the ray tracer, which counts
    /// rays. This copy takes 10 KB of flash. It executes 3 % more instructions than the first copy.
    ///
    /// If the observer [interrupts](Observer::is_interrupted) the renderer, the step ends early.
    /// `progress` is then at the pixel that was abandoned, so a later step traces this pixel again,
    /// and the finished picture is the same as without the interruption.
    ///
    /// # Errors
    /// The step stops at the first error of the display and returns that error. The display may
    /// have shown some pixels of the failed call. `progress` stays at the start of that call, so
    /// the next step repeats it, and the finished picture is the same as without the error.
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
        let mut pixels = tracer.pixels(&self.rays, row.y, row.columns, observer);
        if row.block > 1 {
            return fill_blocks(progress, size, &row, pixels, output, target);
        }
        match row.is_contiguous() {
            true => fill_line(&row, &mut pixels, output, target),
            false => draw_sparse(&row, &mut pixels, output, target),
        }?;
        match pixels.tracer.observer.is_interrupted() {
            true => progress.advance_to(pixels.x, size),
            // If the display took fewer pixels than the row has, it clipped the other pixels.
            // The row is then complete.
            false => progress.finish_row(size),
        }
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
            if self.observer.is_interrupted() {
                break;
            }
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
            && !self.observer.is_interrupted()
            && let Some(row) = progress.row(size)
        {
            let (tracer, observer) = (&mut self.tracer, &mut self.observer);
            let mut both = Pair(&mut counter, observer);
            let mut pixels = RayBudget {
                pixels: tracer.pixels(&self.rays, row.y, row.columns, &mut both),
                budget,
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
            let RayBudget {
                pixels,
                is_exhausted,
                ..
            } = pixels;
            match is_exhausted || pixels.tracer.observer.is_interrupted() {
                true => progress.advance_to(pixels.x, size),
                false => progress.finish_row(size),
            }
        }
        Ok(())
    }
}

/// An iterator over pixels. It ends early once `budget` rays have been traced.
struct RayBudget<'r, 's, 'o, O> {
    pixels: PixelIter<'r, 's, Pair<'o, RayCounter, O>>,
    budget: u32,
    /// True if the iterator ended because the budget was used up.
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
        self.pixels.next()
    }
}
