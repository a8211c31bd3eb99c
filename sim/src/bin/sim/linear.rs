//! Renders scenes to linear colors, without converting them to a display's format.

use std::time::Duration;

use embedded_graphics::geometry::Size;
use whitted::render::{AntialiasedRenderer, SampleCount};
use whitted::{PreparedScene, Renderer};
use whitted_sim::cost::Work;
use whitted_sim::picture::Picture;
use whitted_sim::render;

use crate::draw::two_lines;
use crate::estimate;
use crate::outcome::Outcome;
use crate::progress::Progress;

/// A picture in linear colors, the work that was counted while it was rendered, and the rendering
/// time.
pub(crate) struct Linear {
    pub(crate) picture: Picture,
    pub(crate) work: Work,
    pub(crate) time: Duration,
}

/// Renders a scene with 16-bit linear samples.
pub(crate) fn linear(
    scene: &PreparedScene<'_>,
    size: Size,
    samples: Option<SampleCount>,
) -> Outcome<Linear> {
    estimate::announce(scene, size, 1);
    let mut progress = Progress::new(size.height);
    let work = Work::new(scene, size);
    let (picture, work) = match samples {
        None => {
            let mut renderer = Renderer::with_observer(scene, size, work);
            let picture = render::trace(&mut renderer, |_| progress.line());
            (picture, renderer.observer().clone())
        }
        Some(samples) => {
            let mut memory = two_lines(size);
            let mut renderer =
                AntialiasedRenderer::with_observer(scene, size, samples, &mut memory, work)?;
            let picture = render::lines(size, |y, line| {
                renderer.render_line(y, line);
                progress.line();
            });
            (picture, renderer.observer().clone())
        }
    };
    Ok(Linear {
        picture,
        work,
        time: progress.finish(),
    })
}
