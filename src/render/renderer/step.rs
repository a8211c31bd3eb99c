//! Drawing of a picture in steps of limited work.

use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::Point;

use super::Renderer;
use crate::observer::{Observer, Pair, RayCounter};
use crate::render::DisplayColor;
use crate::render::bounds::Bounds;
use crate::render::canvas::Canvas;
use crate::render::progress::{RenderProgress, Step};
use crate::render::scanline::{PixelIter, TracedPixel, TracedPixels};

impl<O: Observer> Renderer<'_, O> {
    /// Draws the next step of a picture and advances `progress`. Does nothing if the picture is
    /// complete.
    ///
    /// The top left pixel of the picture is at the top left of the target's bounding box. Only the
    /// part of the picture inside the bounding box is traced.
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
        let origin = target.bounding_box().top_left;
        self.step_at::<D, false>(origin, progress, step, target)
    }

    /// Draws the next step of a picture whose top left pixel is at `origin`. If `TRANSPARENT` is
    /// true, only pixels whose camera ray hits an object are drawn.
    #[inline]
    pub(crate) fn step_at<D, const TRANSPARENT: bool>(
        &mut self,
        origin: Point,
        progress: &mut RenderProgress,
        step: Step,
        target: &mut D,
    ) -> Result<(), D::Error>
    where
        D: DrawTarget<Color: DisplayColor>,
    {
        let areas = [progress.area(), &target.bounding_box()];
        let bounds = Bounds::visible(origin, self.size(), areas);
        let canvas = &mut Canvas::<D, TRANSPARENT>::new(target, origin, self.output);
        match step {
            Step::Line => self.step_line(progress, bounds, canvas),
            Step::Pass => self.step_pass(progress, bounds, canvas),
            Step::Rays(budget) => self.step_rays(progress, bounds, budget, canvas),
        }
    }

    fn step_line<D, const TRANSPARENT: bool>(
        &mut self,
        progress: &mut RenderProgress,
        bounds: Bounds,
        canvas: &mut Canvas<'_, D, TRANSPARENT>,
    ) -> Result<(), D::Error>
    where
        D: DrawTarget<Color: DisplayColor>,
    {
        let Some(row) = progress.row(bounds) else {
            return Ok(());
        };
        let (tracer, observer) = (&mut self.tracer, &mut self.observer);
        let mut pixels = tracer.pixels(&self.rays, row.y, row.columns, observer);
        if row.block > 1 {
            return canvas.fill_blocks(progress, bounds, &row, pixels);
        }
        match row.is_contiguous() {
            true => canvas.fill_line(&row, &mut pixels),
            false => canvas.draw_sparse(&row, &mut pixels),
        }?;
        match pixels.tracer.observer.is_interrupted() {
            true => progress.advance_to(pixels.x, bounds),
            // If the display took fewer pixels than the row has, it clipped the other pixels.
            // The row is then complete.
            false => progress.finish_row(bounds),
        }
        Ok(())
    }

    fn step_pass<D, const TRANSPARENT: bool>(
        &mut self,
        progress: &mut RenderProgress,
        bounds: Bounds,
        canvas: &mut Canvas<'_, D, TRANSPARENT>,
    ) -> Result<(), D::Error>
    where
        D: DrawTarget<Color: DisplayColor>,
    {
        let pass = progress.block();
        while progress.block() == pass && !progress.is_complete() {
            self.step_line(progress, bounds, canvas)?;
            if self.observer.is_interrupted() {
                break;
            }
        }
        Ok(())
    }

    fn step_rays<D, const TRANSPARENT: bool>(
        &mut self,
        progress: &mut RenderProgress,
        bounds: Bounds,
        budget: u32,
        canvas: &mut Canvas<'_, D, TRANSPARENT>,
    ) -> Result<(), D::Error>
    where
        D: DrawTarget<Color: DisplayColor>,
    {
        let mut counter = RayCounter::default();
        while counter.0 < budget
            && !self.observer.is_interrupted()
            && let Some(row) = progress.row(bounds)
        {
            let (tracer, observer) = (&mut self.tracer, &mut self.observer);
            let mut both = Pair(&mut counter, observer);
            let mut pixels = RayBudget {
                pixels: tracer.pixels(&self.rays, row.y, row.columns, &mut both),
                budget,
                is_exhausted: false,
            };
            if row.block > 1 {
                canvas.fill_blocks(progress, bounds, &row, pixels)?;
                continue;
            }
            match row.is_contiguous() {
                true => canvas.fill_line(&row, &mut pixels),
                false => canvas.draw_sparse(&row, &mut pixels),
            }?;
            let RayBudget {
                pixels,
                is_exhausted,
                ..
            } = pixels;
            match is_exhausted || pixels.tracer.observer.is_interrupted() {
                true => progress.advance_to(pixels.x, bounds),
                false => progress.finish_row(bounds),
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
    type Item = TracedPixel;

    #[inline(always)]
    fn next(&mut self) -> Option<Self::Item> {
        self.is_exhausted = self.pixels.tracer.observer.0.0 >= self.budget;
        if self.is_exhausted {
            return None;
        }
        self.pixels.next()
    }
}

impl<O: Observer> TracedPixels for RayBudget<'_, '_, '_, O> {
    fn take_miss(&mut self) -> bool {
        self.pixels.take_miss()
    }
}
