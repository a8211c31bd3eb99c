//! Rendering to linear light, before any display's format.

use std::time::Duration;

use embedded_graphics::geometry::Size;
use whitted::{PreparedScene, Renderer};
use whitted_sim::cost::Work;
use whitted_sim::picture::Picture;
use whitted_sim::render;

use crate::progress::Progress;

/// A picture in linear light and what it took.
pub(crate) struct Linear {
    pub(crate) picture: Picture,
    pub(crate) work: Work,
    pub(crate) time: Duration,
}

/// Renders to linear 16-bit samples.
pub(crate) fn linear(scene: &PreparedScene<'_>, size: Size) -> Linear {
    let mut progress = Progress::new(size.height);
    let mut renderer = Renderer::with_observer(scene, size, Work::new(scene));
    let picture = render::trace(&mut renderer, |_| progress.line());
    Linear {
        picture,
        work: renderer.observer().clone(),
        time: progress.finish(),
    }
}
