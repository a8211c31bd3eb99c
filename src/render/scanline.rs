//! Traces scanlines by an iterator. Each pixel is traced only when it is requested.

use crate::geometry::PrimitivePart;
use crate::math::{Color, Radiance};
use crate::observer::Observer;
use crate::prepare::PreparedScene;
use crate::render::camera_rays::CameraRays;
use crate::render::column_range::ColumnRange;
use crate::render::scanline_culler::ScanlineCuller;
use crate::render::scanline_rays::ScanlineRays;
use crate::trace::Tracer;

/// Tracer of the scanlines of a scene.
#[derive(Clone, Debug)]
pub(crate) struct ScanlineTracer<'s> {
    scene: &'s PreparedScene<'s>,
    part: PrimitivePart,
    culler: ScanlineCuller,
}

impl<'s> ScanlineTracer<'s> {
    pub(crate) fn new(scene: &'s PreparedScene<'s>) -> Self {
        Self {
            scene,
            part: PrimitivePart::default(),
            culler: ScanlineCuller::default(),
        }
    }

    /// Returns an iterator that traces some columns of line `y`. The iterator is empty if `y` is
    /// outside the picture.
    #[inline(never)]
    pub(crate) fn pixels<'r, O: Observer>(
        &'r mut self,
        rays: &CameraRays,
        y: u32,
        columns: ColumnRange,
        observer: &'r mut O,
    ) -> PixelIter<'r, 's, O> {
        self.culler.set_row(self.scene, rays, y);
        PixelIter {
            directions: rays.line(y).through(columns),
            x: columns.from,
            spacing: columns.spacing,
            culler: &mut self.culler,
            tracer: Tracer {
                scene: self.scene,
                part: &mut self.part,
                observer,
            },
        }
    }

    /// Traces pixel (x, y) and returns its color, or black if the pixel is outside the picture.
    pub(crate) fn pixel(
        &mut self,
        rays: &CameraRays,
        x: u32,
        y: u32,
        observer: &mut impl Observer,
    ) -> Color<Radiance> {
        let columns = ColumnRange {
            from: x,
            to: x.saturating_add(1),
            spacing: 0,
        };
        let mut pixels = self.pixels(rays, y, columns, observer);
        pixels
            .next()
            .map_or(Color::<Radiance>::BLACK, |(_, color)| color)
    }
}

/// Column and color of a traced pixel.
pub(crate) type TracedPixel = (u32, Color<Radiance>);

/// An iterator over traced pixels of a scanline, from left to right.
pub(crate) trait TracedPixels: Iterator<Item = TracedPixel> {
    /// Returns true if the camera ray of the most recent pixel hit nothing. Calling this function
    /// once more for the same pixel returns false.
    fn take_miss(&mut self) -> bool;
}

impl<P: TracedPixels> TracedPixels for &mut P {
    fn take_miss(&mut self) -> bool {
        (**self).take_miss()
    }
}

/// Iterator that traces the pixels of a scanline and returns the column and color of each. The
/// iterator ends before the pixel in which the observer interrupts it.
pub(crate) struct PixelIter<'r, 's, O> {
    directions: ScanlineRays,
    /// Column of the next pixel.
    pub(crate) x: u32,
    spacing: u8,
    culler: &'r mut ScanlineCuller,
    pub(crate) tracer: Tracer<'r, 's, O>,
}

impl<O> PixelIter<'_, '_, O> {
    /// Skips the pixels before column `x`.
    pub(crate) fn skip_to(&mut self, x: u32) {
        let count = x.saturating_sub(self.x) >> self.spacing;
        self.directions.skip_rays(count);
        self.x += count << self.spacing;
    }
}

impl<O: Observer> Iterator for PixelIter<'_, '_, O> {
    type Item = TracedPixel;

    #[inline(always)]
    fn next(&mut self) -> Option<Self::Item> {
        if self.tracer.observer.is_interrupted() {
            return None;
        }
        let direction = self.directions.next()?;
        let x = self.x;
        self.x += 1 << self.spacing;
        let candidates = self.culler.at_column(x);
        let color = self.tracer.trace_camera_ray(direction, candidates);
        if self.tracer.observer.is_interrupted() {
            self.x = x;
            return None;
        }
        Some((x, color))
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        self.directions.size_hint()
    }
}

impl<O: Observer> TracedPixels for PixelIter<'_, '_, O> {
    fn take_miss(&mut self) -> bool {
        self.culler.take_miss()
    }
}
