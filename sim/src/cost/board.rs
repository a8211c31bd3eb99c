/// A core at a clock, as a well-known chip has it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Board {
    /// The core's short name, as in the file of the model.
    pub core: &'static str,
    /// The core's name for people.
    pub title: &'static str,
    /// The chip.
    pub chip: &'static str,
    /// Its clock, in MHz: the highest that its data sheet allows.
    pub megahertz: u32,
}

const fn board(
    core: &'static str,
    title: &'static str,
    chip: &'static str,
    megahertz: u32,
) -> Board {
    Board {
        core,
        title,
        chip,
        megahertz,
    }
}

/// One for each core.
pub const BOARDS: [Board; 5] = [
    board("m0", "Cortex-M0+", "RP2040", 133),
    board("m3", "Cortex-M3", "STM32F103", 72),
    board("m4f", "Cortex-M4F", "STM32F407", 168),
    board("m33", "Cortex-M33", "RP2350", 150),
    board("m7", "Cortex-M7", "STM32H743", 480),
];
