//! Announces renderings that take minutes.

use std::io::Write;
use std::time::{Duration, Instant};

use embedded_graphics::geometry::Size;
use whitted::{PreparedScene, Renderer};

use crate::console::Console;
use crate::number::long_duration;

/// Longest time for an estimate.
const BUDGET: Duration = Duration::from_millis(100);

/// Shortest rendering time that is announced.
const LONG: Duration = Duration::from_secs(60);

/// Estimates the time to render a number of pictures of a scene. Prints the time to stderr if it is
/// more than a minute.
pub(crate) fn announce(scene: &PreparedScene<'_>, size: Size, pictures: usize) {
    let seconds = seconds_per_pixel(scene, size) * pixels(size) * pictures as f64;
    if seconds >= LONG.as_secs_f64() {
        let time = long_duration(seconds);
        // The messages of stderr are lost if it is closed.
        _ = writeln!(
            Console::Stderr,
            "note: rendering takes about {time}, and longer with antialiasing"
        );
    }
}

/// Measures the mean time of a pixel. Traces up to 1/64 of the pixels, so that the estimate takes
/// little time beside the rendering.
fn seconds_per_pixel(scene: &PreparedScene<'_>, size: Size) -> f64 {
    let mut renderer = Renderer::new(scene, size);
    let start = Instant::now();
    let mut count = 0_u32;
    while f64::from(count) < pixels(size) / 64.0 && start.elapsed() < BUDGET {
        let [x, y] = position(count, size);
        renderer.pixel(x, y);
        count += 1;
    }
    start.elapsed().as_secs_f64() / f64::from(count.max(1))
}

/// Returns the pixel with an index in a sequence that covers the picture evenly. The factors are
/// the inverse powers of the plastic ratio, 1.3247 (Roberts 2018).
fn position(index: u32, size: Size) -> [u32; 2] {
    let fractions = [0.754_877_666_246_693, 0.569_840_290_998_053];
    let [x, y] = fractions.map(|fraction| (0.5 + fraction * f64::from(index)).fract());
    let pixel = |fraction: f64, side: u32| (fraction * f64::from(side)) as u32;
    [pixel(x, size.width), pixel(y, size.height)]
}

fn pixels(size: Size) -> f64 {
    f64::from(size.width) * f64::from(size.height)
}
