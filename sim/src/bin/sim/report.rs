use std::io::Write;
use std::path::Path;
use std::time::Duration;

use whitted::observer::Stats;
use whitted_sim::cost::Work;

use crate::boards;
use crate::console::Console;
use crate::outcome::Outcome;

/// Prints the path of a written file. Prints nothing if the file was written to stdout.
pub(crate) fn wrote(mut console: Console, path: &Path) -> Outcome {
    if console == Console::Stderr {
        return Ok(());
    }
    let path = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
    Ok(writeln!(console, "wrote {}", path.display())?)
}

/// Prints the numbers of rays and intersection tests of a frame, its rendering time on the host,
/// and its estimated time on microcontrollers.
pub(crate) fn stats(mut console: Console, work: &Work, time: Duration) -> Outcome {
    let Stats {
        camera,
        reflected,
        transmitted,
        shadow,
        intersections,
        ..
    } = work.stats;
    writeln!(
        console,
        "rays: {camera} camera, {reflected} reflected, {transmitted} transmitted, {shadow} shadow"
    )?;
    writeln!(console, "intersection tests: {intersections}")?;
    writeln!(console, "time: {:.3} s", time.as_secs_f64())?;
    boards::print(console, work)
}

/// Prints the checksum of a picture's linear samples.
pub(crate) fn checksum(mut console: Console, checksum: u32) -> Outcome {
    Ok(writeln!(console, "checksum: {checksum:08x}")?)
}
