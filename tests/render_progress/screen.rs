//! Display that records its calls and can fail.

use std::collections::HashMap;

use embedded_graphics::Pixel;
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use fastrand::Rng;

/// Successful call of the display.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Call {
    /// Area and number of pixels of `fill_contiguous`.
    Fill(Rectangle, usize),
    /// Pixels of `draw_iter`.
    Dots(Vec<Point>),
}

/// Display that records its calls and can fail.
#[derive(Default)]
pub(crate) struct Screen {
    pub(crate) shown: HashMap<Point, Rgb888>,
    /// Pixels of all successful calls, in order.
    pub(crate) sent: Vec<(Point, Rgb888)>,
    pub(crate) calls: Vec<Call>,
    /// Returns, for each call that fails, the number of pixels shown before.
    fails: Option<Box<dyn FnMut() -> Option<usize>>>,
}

#[derive(Debug, PartialEq)]
pub(crate) struct Unplugged;

impl Screen {
    /// Every call fails with a probability of `1 / once_in`, after 0 to 19 pixels.
    pub(crate) fn failing_at_random(mut rng: Rng, once_in: u32) -> Self {
        let fails = move || (rng.u32(0..once_in) == 0).then(|| rng.usize(0..20));
        Self {
            fails: Some(Box::new(fails)),
            ..Self::default()
        }
    }

    /// Only this call fails, after this number of pixels.
    pub(crate) fn failing_at(call: usize, pixels: usize) -> Self {
        let mut calls = 0..;
        let fails = move || (calls.next() == Some(call)).then_some(pixels);
        Self {
            fails: Some(Box::new(fails)),
            ..Self::default()
        }
    }

    /// Shows the pixels of one call, up to its failure. Returns their points.
    fn show(
        &mut self,
        pixels: impl Iterator<Item = (Point, Rgb888)>,
    ) -> Result<Vec<Point>, Unplugged> {
        let failure = self.fails.as_mut().and_then(|fails| fails());
        let before = self.sent.len();
        for (index, (point, color)) in pixels.enumerate() {
            if failure.is_some_and(|after| index >= after) {
                break;
            }
            self.shown.insert(point, color);
            self.sent.push((point, color));
        }
        if failure.is_some() {
            self.sent.truncate(before);
            return Err(Unplugged);
        }
        Ok(self.sent[before..]
            .iter()
            .map(|(point, _)| *point)
            .collect())
    }
}

impl OriginDimensions for Screen {
    fn size(&self) -> Size {
        Size::new(1000, 1000)
    }
}

impl DrawTarget for Screen {
    type Color = Rgb888;
    type Error = Unplugged;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Unplugged>
    where
        I: IntoIterator<Item = Pixel<Rgb888>>,
    {
        let pixels = pixels.into_iter().map(|Pixel(point, color)| (point, color));
        let points = self.show(pixels)?;
        self.calls.push(Call::Dots(points));
        Ok(())
    }

    fn fill_contiguous<I>(&mut self, area: &Rectangle, colors: I) -> Result<(), Unplugged>
    where
        I: IntoIterator<Item = Rgb888>,
    {
        assert!(!area.is_zero_sized());
        let mut colors = colors.into_iter();
        let points = self.show(area.points().zip(&mut colors))?;
        assert_eq!(colors.next(), None, "more colors than pixels");
        self.calls.push(Call::Fill(*area, points.len()));
        Ok(())
    }
}
