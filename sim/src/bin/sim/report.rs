use std::path::Path;
use std::time::Duration;

use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics_simulator::OutputImage;
use whitted::observer::Stats;
use whitted_sim::cost::Work;

use crate::boards;
use crate::outcome::Outcome;

/// Prints the path of a written file.
pub(crate) fn wrote(path: &Path) {
    let path = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
    println!("wrote {}", path.display());
}

/// Writes a picture as a PNG and prints its path.
pub(crate) fn save(image: &OutputImage<Rgb888>, path: &Path) -> Outcome {
    image
        .save_png(path)
        .map_err(|error| format!("{}: cannot be written: {error}", path.display()))?;
    wrote(path);
    Ok(())
}

/// Prints the numbers of rays and intersection tests of a frame, its rendering time on the host,
/// and its estimated time on microcontrollers.
pub(crate) fn stats(work: &Work, time: Duration) -> Outcome {
    let Stats {
        camera,
        reflected,
        transmitted,
        shadow,
        intersections,
        ..
    } = work.stats;
    println!(
        "rays: {camera} camera, {reflected} reflected, {transmitted} transmitted, {shadow} shadow"
    );
    println!("intersection tests: {intersections}");
    println!("time: {:.3} s", time.as_secs_f64());
    boards::print(work);
    Ok(())
}

/// Prints the checksum of a picture's linear samples.
pub(crate) fn checksum(checksum: u32) {
    println!("checksum: {checksum:08x}");
}
