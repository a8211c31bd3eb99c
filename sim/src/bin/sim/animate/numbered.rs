use std::fs;
use std::path::{Path, PathBuf};

use embedded_graphics::geometry::Size;

use super::film::{Film, unwritable};
use super::schedule::Schedule;
use crate::outcome::Outcome;

/// Writes each frame of an animation to a PNG with a number: `frame-0000.png`, `frame-0001.png` and
/// so on.
struct Numbered {
    directory: PathBuf,
    size: Size,
    digits: usize,
    count: usize,
}

pub(super) fn film(directory: &Path, size: Size, schedule: &Schedule) -> Outcome<Box<dyn Film>> {
    fs::create_dir_all(directory)
        .map_err(|error| format!("{}: cannot be created: {error}", directory.display()))?;
    Ok(Box::new(Numbered {
        directory: directory.to_owned(),
        size,
        digits: schedule.times.len().to_string().len().max(4),
        count: 0,
    }))
}

impl Film for Numbered {
    fn add(&mut self, pixels: &[u8]) -> Outcome {
        let name = format!("frame-{:0digits$}.png", self.count, digits = self.digits);
        let path = self.directory.join(name);
        let Size { width, height } = self.size;
        image::save_buffer(&path, pixels, width, height, image::ColorType::Rgb8)
            .map_err(|error| unwritable(&path, error))?;
        self.count += 1;
        Ok(())
    }

    fn finish(self: Box<Self>) -> Outcome {
        Ok(())
    }
}
