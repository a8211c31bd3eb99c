//! Lines of pixels, traced one by one as they are asked for.

use crate::math::{Color, Radiance};
use crate::observer::Observer;
use crate::prepare::PreparedScene;
use crate::render::camera_rays::{CameraRays, ColumnRange, ScanlineRays};
use crate::render::scanline_culler::ScanlineCuller;
use crate::geometry::PrimitivePart;
use crate::trace::Tracer;

/// A scene, and what tracing the pixels of views of it takes.
#[derive(Clone, Debug)]
pub(crate) struct ScanlineTracer<'s> {
    scene: &'s PreparedScene<'s>,
    part: PrimitivePart,
    coverage: ScanlineCuller,
}

impl<'s> ScanlineTracer<'s> {
    pub(crate) fn new(scene: &'s PreparedScene<'s>) -> Self {
        Self {
            scene,
            part: PrimitivePart::default(),
            coverage: ScanlineCuller::default(),
        }
    }

    /// The pixels of some columns of a view's line `y`, with their columns. A
    /// line outside of the view is empty.
    #[inline(never)]
    pub(crate) fn pixels<'r, O: Observer>(
        &'r mut self,
        view: &CameraRays,
        y: u32,
        columns: ColumnRange,
        observer: &'r mut O,
    ) -> PixelIter<'r, 's, O> {
        self.coverage.look(self.scene, view, y);
        PixelIter {
            directions: view.line(y).through(columns),
            x: columns.from,
            spacing: columns.spacing,
            coverage: &mut self.coverage,
            tracer: Tracer {
                scene: self.scene,
                part: &mut self.part,
                observer,
            },
        }
    }

    /// A single pixel of a view; black outside of it.
    pub(crate) fn pixel(
        &mut self,
        view: &CameraRays,
        x: u32,
        y: u32,
        observer: &mut impl Observer,
    ) -> Color<Radiance> {
        let columns = ColumnRange {
            from: x,
            to: x.saturating_add(1),
            spacing: 0,
        };
        let mut pixels = self.pixels(view, y, columns, observer);
        pixels
            .next()
            .map_or(Color::<Radiance>::BLACK, |(_, color)| color)
    }
}

/// Pixels of a line as they are traced.
pub(crate) struct PixelIter<'r, 's, O> {
    directions: ScanlineRays,
    x: u32,
    spacing: u8,
    coverage: &'r mut ScanlineCuller,
    pub(crate) tracer: Tracer<'r, 's, O>,
}

impl<O> PixelIter<'_, '_, O> {
    /// Passes over the pixels before column `x`.
    pub(crate) fn pass_to(&mut self, x: u32) {
        let count = x.saturating_sub(self.x) >> self.spacing;
        self.directions.pass(count);
        self.x += count << self.spacing;
    }
}

impl<O: Observer> Iterator for PixelIter<'_, '_, O> {
    type Item = (u32, Color<Radiance>);

    #[inline(always)]
    fn next(&mut self) -> Option<Self::Item> {
        let direction = self.directions.next()?;
        let x = self.x;
        self.x += 1 << self.spacing;
        let candidates = self.coverage.at(x);
        let color = self.tracer.trace_camera_ray(direction, candidates);
        Some((x, color))
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        self.directions.size_hint()
    }
}
