//! The Cortex-M cores that QEMU emulates.

use std::fmt;

use clap::ValueEnum;

/// A core that the headless firmware runs on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, ValueEnum)]
pub enum Core {
    /// Cortex-M0+. QEMU runs the code for this core on a Cortex-M3, because QEMU's only board with
    /// a Cortex-M0 has just 16 KB of RAM.
    M0,
    /// Cortex-M3.
    M3,
    /// Cortex-M4 with an FPU.
    M4f,
    /// Cortex-M7 with an FPU. It runs the machine code of the M4F.
    M7,
    /// Cortex-M33 with an FPU.
    M33,
}

impl Core {
    /// All cores.
    pub const ALL: [Self; 5] = [Self::M0, Self::M3, Self::M4f, Self::M7, Self::M33];

    /// All cores but the M7, which runs the machine code of the M4F.
    pub const DISTINCT: [Self; 4] = [Self::M0, Self::M3, Self::M4f, Self::M33];

    /// Returns the name of the core in tables.
    pub fn title(self) -> &'static str {
        match self {
            Self::M0 => "Cortex-M0+",
            Self::M3 => "Cortex-M3",
            Self::M4f => "Cortex-M4F",
            Self::M7 => "Cortex-M7",
            Self::M33 => "Cortex-M33",
        }
    }

    /// Returns true if the core has hardware for floating point.
    pub fn has_fpu(self) -> bool {
        !matches!(self, Self::M0 | Self::M3)
    }
}

/// Writes the name of the core on the command line, such as `m4f`.
impl fmt::Display for Core {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", format!("{self:?}").to_lowercase())
    }
}
