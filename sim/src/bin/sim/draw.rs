//! Rendering as a display gets it: through `Renderer::draw`, in its pixels.

use std::time::Duration;

use embedded_graphics::pixelcolor::{
    BinaryColor, Gray2, Gray4, Gray8, Rgb555, Rgb565, Rgb666, Rgb888,
};
use embedded_graphics::prelude::*;
use embedded_graphics_simulator::{OutputImage, OutputSettings, SimulatorDisplay};
use whitted::{Output, PreparedScene, Renderer};

use whitted_sim::cost::Work;

use crate::args::{Format, Shown};
use crate::outcome::Outcome;
use crate::progress::{Progress, Watched};

/// A display's picture and what it took.
pub(crate) struct Drawing {
    pub(crate) image: OutputImage<Rgb888>,
    pub(crate) work: Work,
    pub(crate) time: Duration,
}

/// Draws on a display.
pub(crate) fn draw(scene: &PreparedScene<'_>, size: Size, shown: Shown) -> Outcome<Drawing> {
    let draw = match shown.format {
        Format::Rgb888 => on_display::<Rgb888>,
        Format::Rgb666 => on_display::<Rgb666>,
        Format::Rgb565 => on_display::<Rgb565>,
        Format::Rgb555 => on_display::<Rgb555>,
        Format::Gray8 => on_display::<Gray8>,
        Format::Gray4 => on_display::<Gray4>,
        Format::Gray2 => on_display::<Gray2>,
        Format::Binary => on_display::<BinaryColor>,
    };
    draw(scene, size, shown.output())
}

fn on_display<C>(scene: &PreparedScene<'_>, size: Size, output: Output) -> Outcome<Drawing>
where
    C: PixelColor + whitted::Pixel + From<BinaryColor> + Into<Rgb888>,
{
    let mut display = SimulatorDisplay::<C>::new(size);
    let mut renderer = Renderer::with_observer(scene, size, Work::new(scene));
    renderer.set_output(output);
    let mut watched = Watched {
        display: &mut display,
        progress: Progress::new(size.height),
    };
    renderer.draw(&mut watched)?;
    let time = watched.progress.finish();
    // The default settings show the display's values as they are.
    let image = display.to_rgb_output_image(&OutputSettings::default());
    Ok(Drawing {
        image,
        work: renderer.observer().clone(),
        time,
    })
}
