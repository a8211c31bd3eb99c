use super::prices::PRICES;
use super::work::Work;

/// A common chip with one of the supported cores. The chip runs at its highest clock.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Board {
    /// Name of the core, such as "Cortex-M3".
    pub title: &'static str,
    /// Name of the chip.
    pub chip: &'static str,
    /// Highest clock in the chip's data sheet, in MHz.
    pub megahertz: u32,
    /// Row of the core in [`PRICES`].
    prices: usize,
    /// Average number of clock cycles per instruction. docs/cost-model.md names the sources of the
    /// values.
    cycles: f64,
}

/// The boards, one for each core. The Cortex-M7 runs the same machine code as the Cortex-M4F, so
/// both cores have the same prices.
pub const BOARDS: [Board; 5] = [
    board("Cortex-M0+", "RP2040", 133, 0, 1.40),
    board("Cortex-M3", "STM32F103", 72, 1, 1.73),
    board("Cortex-M4F", "STM32F407", 168, 2, 1.55),
    board("Cortex-M33", "RP2350", 150, 3, 1.32),
    board("Cortex-M7", "STM32H743", 480, 2, 1.06),
];

const fn board(
    title: &'static str,
    chip: &'static str,
    megahertz: u32,
    prices: usize,
    cycles: f64,
) -> Board {
    Board {
        title,
        chip,
        megahertz,
        prices,
        cycles,
    }
}

impl Board {
    /// Returns the estimated instructions of a frame.
    pub fn instructions(&self, work: &Work) -> f64 {
        let products = work.amounts().into_iter().zip(PRICES[self.prices]);
        products
            .map(|(amount, price)| amount as f64 * f64::from(price))
            .sum()
    }

    /// Returns the estimated seconds of a frame.
    pub fn seconds(&self, work: &Work) -> f64 {
        self.instructions(work) * self.cycles / (f64::from(self.megahertz) * 1e6)
    }
}

#[cfg(test)]
mod tests {
    use std::error::Error;
    use std::path::Path;

    use embedded_graphics_core::geometry::Size;

    use super::super::COUNTED;
    use super::*;
    use crate::scene_file;

    /// Largest allowed error of an estimated number of instructions, as a share of the counted
    /// number.
    const TOLERANCE: f64 = 0.25;

    #[test]
    fn estimates_are_within_a_quarter_of_counted_instructions() -> Result<(), Box<dyn Error>> {
        let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/scenes");
        assert!(!COUNTED.is_empty());
        let mut errors = Vec::new();
        for (name, [width, height], counted) in COUNTED {
            let file = scene_file::load(scenes.join(name).with_extension("toml"))?;
            let mut buffer = Box::new(scene_file::Buffer::new());
            let work = Work::of(&file.prepare(&mut buffer)?, Size::new(width, height));
            for (board, counted) in BOARDS.iter().zip(counted) {
                let error = board.instructions(&work) / f64::from(counted) - 1.0;
                errors.push(100.0 * error.abs());
                assert!(
                    error.abs() < TOLERANCE,
                    "{name} {width}x{height} on {}: {:+.0} %; run `cargo xtask fit`",
                    board.title,
                    100.0 * error
                );
            }
        }
        let mean = errors.iter().sum::<f64>() / errors.len() as f64;
        let largest = errors.into_iter().fold(0.0, f64::max);
        println!("mean error {mean:.1} %, largest {largest:.1} %");
        Ok(())
    }
}
