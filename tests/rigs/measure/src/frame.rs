use core::fmt;

use embedded_graphics_core::prelude::{DrawTarget, Size};
use whitted::Renderer;
use whitted::render::DisplayColor;

use crate::{Checksum, Stopwatch, memory};

/// Measurements of a frame and of the firmware that drew it.
pub struct Report {
    size: Size,
    instructions: u64,
    stack: usize,
    checksum: Option<u32>,
}

impl Report {
    /// Creates a report with the instruction count of the stopwatch and the stack used so
    /// far.
    pub fn new(size: Size, stopwatch: &Stopwatch) -> Self {
        Self {
            size,
            instructions: stopwatch.instructions(),
            stack: memory::peak_stack(),
            checksum: None,
        }
    }

    /// Adds the checksum of the frame to the report.
    pub fn with_checksum(self, checksum: u32) -> Self {
        Self {
            checksum: Some(checksum),
            ..self
        }
    }
}

/// Draws a frame line by line and measures it, then traces it again for the checksum.
///
/// The instruction count includes tracing, color conversion, the display driver, and
/// everything since the stopwatch was started, such as decoding the scene.
///
/// # Errors
/// Returns the first error of the display.
#[inline(never)]
pub fn draw<D>(
    renderer: &mut Renderer<'_>,
    target: &mut D,
    stopwatch: &mut Stopwatch,
) -> Result<Report, D::Error>
where
    D: DrawTarget,
    D::Color: DisplayColor,
{
    let size = renderer.size();
    for y in 0..size.height {
        renderer.draw_line(y, target)?;
        stopwatch.lap();
    }
    let report = Report::new(size, stopwatch);
    Ok(report.with_checksum(checksum(renderer)))
}

/// Traces the frame for its checksum.
///
/// The function is kept out of line, because `cargo xtask profile` stops profiling where
/// this function starts.
#[inline(never)]
fn checksum(renderer: &mut Renderer<'_>) -> u32 {
    let mut checksum = Checksum::default();
    loop {
        if let Some(checksum) = checksum.line(renderer) {
            return checksum;
        }
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Size { width, height } = self.size;
        writeln!(f, "size: {width}x{height}")?;
        if let Some(checksum) = self.checksum {
            writeln!(f, "checksum: {checksum:08x}")?;
        }
        writeln!(f, "instructions: {}", self.instructions)?;
        writeln!(f, "stack: {}", self.stack)?;
        writeln!(f, "flash: {}", memory::flash())?;
        writeln!(f, "statics: {}", memory::statics())
    }
}
