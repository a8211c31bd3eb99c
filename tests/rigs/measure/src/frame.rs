use core::fmt;

use embedded_graphics_core::prelude::{DrawTarget, Size};
use whitted::Renderer;
use whitted::render::DisplayColor;

use crate::{Checksum, Stopwatch, memory};

/// What there is to tell about a frame and the firmware that drew it.
pub struct Report {
    size: Size,
    instructions: u64,
    stack: usize,
    checksum: Option<u32>,
}

impl Report {
    /// Of a frame of this size that was drawn just now, and all that the
    /// stopwatch counted for it.
    pub fn new(size: Size, stopwatch: &Stopwatch) -> Self {
        Self {
            size,
            instructions: stopwatch.instructions(),
            stack: memory::peak_stack(),
            checksum: None,
        }
    }

    /// With a checksum of the frame.
    pub fn with_checksum(self, checksum: u32) -> Self {
        Self {
            checksum: Some(checksum),
            ..self
        }
    }
}

/// Draws a frame line by line, then traces it again for the checksum.
///
/// Instructions and stack are those of the frame that is drawn: whatever the
/// stopwatch has seen before, such as the decoding of the scene, then tracing,
/// conversion to the display's colors, and the display's driver.
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

/// Traces the frame for its checksum. A function of its own, as its start tells
/// `cargo xtask profile` that the frame is drawn.
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
