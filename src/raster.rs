//! Lines of pixels, traced one by one as they are asked for.

use crate::camera::{Columns, Line, View};
use crate::coverage::Coverage;
use crate::num::Radiance;
use crate::observer::Observer;
use crate::tracer::{Scratch, trace};
use crate::{Color, PreparedScene};

/// A scene before a raster of pixels, and what tracing them takes.
#[derive(Clone, Debug)]
pub(crate) struct Raster<'s> {
    scene: &'s PreparedScene<'s>,
    view: View,
    scratch: Scratch,
    coverage: Coverage,
}

impl<'s> Raster<'s> {
    pub(crate) fn new(scene: &'s PreparedScene<'s>, width: u32, height: u32) -> Self {
        Self {
            scene,
            view: View::new(&scene.settings.camera, width, height),
            scratch: Scratch::default(),
            coverage: Coverage::default(),
        }
    }

    pub(crate) fn width(&self) -> u32 {
        self.view.width
    }

    pub(crate) fn height(&self) -> u32 {
        self.view.height
    }

    pub(crate) fn columns(&self) -> Columns {
        Columns {
            from: 0,
            to: self.view.width,
            spacing: 0,
        }
    }

    /// The pixels of some columns of line `y`, with their columns. A line outside
    /// of the raster is empty.
    pub(crate) fn pixels<'r, O>(
        &'r mut self,
        y: u32,
        columns: Columns,
        observer: &'r mut O,
    ) -> Pixels<'r, O> {
        self.coverage.look(self.scene, &self.view, y);
        Pixels {
            rays: self.view.line(y).through(columns),
            x: columns.from,
            stride: 1 << columns.spacing,
            scene: self.scene,
            coverage: &mut self.coverage,
            scratch: &mut self.scratch,
            observer,
        }
    }

    /// A single pixel; black outside of the raster.
    pub(crate) fn pixel(
        &mut self,
        x: u32,
        y: u32,
        observer: &mut impl Observer,
    ) -> Color<Radiance> {
        let mut rays = self.view.line(y);
        rays.skip_to(x);
        rays.next().map_or(Color::<Radiance>::BLACK, |ray| {
            trace(self.scene, &ray, None, &mut self.scratch, observer)
        })
    }
}

/// Pixels of a line as they are traced.
pub(crate) struct Pixels<'r, O> {
    rays: Line,
    x: u32,
    stride: u32,
    scene: &'r PreparedScene<'r>,
    coverage: &'r mut Coverage,
    scratch: &'r mut Scratch,
    pub(crate) observer: &'r mut O,
}

impl<O: Observer> Iterator for Pixels<'_, O> {
    type Item = (u32, Color<Radiance>);

    #[inline(always)]
    fn next(&mut self) -> Option<Self::Item> {
        let ray = self.rays.next()?;
        let x = self.x;
        self.x += self.stride;
        let candidates = self.coverage.at(x);
        let color = trace(self.scene, &ray, candidates, self.scratch, self.observer);
        Some((x, color))
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        self.rays.size_hint()
    }
}
