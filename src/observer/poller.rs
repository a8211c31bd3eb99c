use core::fmt;
use core::ops::ControlFlow;

use crate::observer::{Observer, RayKind, ShapeKind};

/// Calls a function after every so many rays and intersection tests, even inside a pixel.
///
/// A pixel of a slow scene can take minutes on a microcontroller. The function can feed a watchdog
/// and read buttons during that time. If it returns [`ControlFlow::Break`], the renderer abandons
/// the current pixel and returns to the caller, see [`Observer::is_interrupted`].
///
/// Rays of all kinds and intersection tests count one each. On a Cortex-M0+, each of them takes
/// between 100 and 5,000 cycles, and usually about 300.
///
/// ```
/// # use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb565, prelude::*};
/// # use whitted::{Camera, Scene, SceneBuffer, real, vec3};
/// # struct Watchdog(u32);
/// # impl Watchdog { fn feed(&mut self) { self.0 += 1; } }
/// # struct Button;
/// # impl Button { fn is_pressed(&self) -> bool { false } }
/// # let (mut watchdog, button) = (Watchdog(0), Button);
/// # let mut display = MockDisplay::<Rgb565>::new();
/// # let scene = Scene::new(Camera::new(vec3!(0, 2, 8), vec3!(0, 1, 0), real!(33)));
/// # let mut buffer = SceneBuffer::<1, 1, 1>::new();
/// # let scene = buffer.prepare(&scene).unwrap();
/// use core::ops::ControlFlow;
/// use whitted::Renderer;
/// use whitted::observer::Poller;
///
/// let poller = Poller::new(200, || {
///     watchdog.feed();
///     match button.is_pressed() {
///         true => ControlFlow::Break(()),
///         false => ControlFlow::Continue(()),
///     }
/// });
/// let mut renderer = Renderer::with_observer(&scene, display.size(), poller);
/// renderer.draw(&mut display).unwrap();
/// if renderer.observer().is_interrupted() {
///     // The button was pressed, and the picture is incomplete.
/// }
/// # assert!(!renderer.observer().is_interrupted());
/// # assert_eq!(watchdog.0, 64 * 64 / 200);
/// ```
pub struct Poller<F> {
    interval: u32,
    /// Number of rays and tests until the next call of `poll`.
    remaining: u32,
    is_interrupted: bool,
    poll: F,
}

impl<F: FnMut() -> ControlFlow<()>> Poller<F> {
    /// Returns an observer that calls `poll` after every `interval` rays and intersection tests.
    /// An interval of 0 counts as 1.
    pub fn new(interval: u32, poll: F) -> Self {
        let interval = interval.max(1);
        Self {
            interval,
            remaining: interval,
            is_interrupted: false,
            poll,
        }
    }

    /// Returns true if the function has returned [`ControlFlow::Break`]. The function is not called
    /// again, and the renderer draws nothing, until [`resume`](Self::resume) is called.
    pub fn is_interrupted(&self) -> bool {
        self.is_interrupted
    }

    /// Ends the interruption, so that the renderer can continue. The next step traces the abandoned
    /// pixel again.
    pub fn resume(&mut self) {
        self.is_interrupted = false;
    }

    #[inline(always)]
    fn count(&mut self) {
        self.remaining = self.remaining.wrapping_sub(1);
        if self.remaining == 0 {
            self.poll();
        }
    }

    #[inline(never)]
    fn poll(&mut self) {
        self.remaining = self.interval;
        self.is_interrupted = self.is_interrupted || (self.poll)().is_break();
    }
}

impl<F: FnMut() -> ControlFlow<()>> Observer for Poller<F> {
    const OBSERVES_NODES: bool = false;

    #[inline(always)]
    fn ray(&mut self, _: RayKind) {
        self.count();
    }

    #[inline(always)]
    fn test(&mut self, _: ShapeKind, _: bool) {
        self.count();
    }

    fn is_interrupted(&self) -> bool {
        self.is_interrupted
    }
}

impl<F> fmt::Debug for Poller<F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            interval,
            is_interrupted,
            ..
        } = self;
        f.debug_struct("Poller")
            .field("interval", interval)
            .field("is_interrupted", is_interrupted)
            .finish_non_exhaustive()
    }
}
