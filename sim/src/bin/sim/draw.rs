//! Rendering as a display gets it: through `Renderer::draw`, in its pixels.

use std::time::Duration;

use embedded_graphics::pixelcolor::{BinaryColor, Gray2, Gray4, Gray8, Rgb565, Rgb888};
use embedded_graphics::prelude::*;
use embedded_graphics_simulator::{OutputImage, OutputSettings, SimulatorDisplay};
use whitted::{PreparedScene, Renderer};

use whitted_sim::cost::Work;

use crate::args::Format;
use crate::outcome::Outcome;
use crate::progress::{Progress, Watched};

/// A display's picture and what it took.
pub(crate) struct Drawing {
    pub(crate) image: OutputImage<Rgb888>,
    pub(crate) work: Work,
    pub(crate) time: Duration,
}

/// Draws on a display of the format.
pub(crate) fn draw(scene: &PreparedScene<'_>, size: Size, format: Format) -> Outcome<Drawing> {
    let mut progress = Progress::new(size.height);
    let (image, work) = frame(scene, size, format, &mut progress)?;
    let time = progress.finish();
    Ok(Drawing { image, work, time })
}

/// Draws on a display of the format, as a part of more work.
pub(crate) fn frame(
    scene: &PreparedScene<'_>,
    size: Size,
    format: Format,
    progress: &mut Progress,
) -> Outcome<(OutputImage<Rgb888>, Work)> {
    match format {
        Format::Rgb888 => on_display::<Rgb888>(scene, size, progress),
        Format::Rgb565 => on_display::<Rgb565>(scene, size, progress),
        Format::Gray8 => on_display::<Gray8>(scene, size, progress),
        Format::Gray4 => on_display::<Gray4>(scene, size, progress),
        Format::Gray2 => on_display::<Gray2>(scene, size, progress),
        Format::Bw => on_display::<BinaryColor>(scene, size, progress),
    }
}

fn on_display<C>(
    scene: &PreparedScene<'_>,
    size: Size,
    progress: &mut Progress,
) -> Outcome<(OutputImage<Rgb888>, Work)>
where
    C: PixelColor + whitted::Pixel + From<BinaryColor> + Into<Rgb888>,
{
    let mut display = SimulatorDisplay::<C>::new(size);
    let mut renderer = Renderer::with_observer(scene, size, Work::new(scene));
    renderer.draw(&mut Watched {
        display: &mut display,
        progress,
    })?;
    // The default settings show the display's values as they are.
    let image = display.to_rgb_output_image(&OutputSettings::default());
    Ok((image, renderer.observer().clone()))
}
