use std::fmt;

use embedded_graphics_core::geometry::Size;

use crate::core::Core;

/// A picture of the benchmark.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Subject {
    /// Name of the scene file.
    pub(super) scene: &'static str,
    pub(super) size: Size,
}

const fn subject(scene: &'static str, width: u32, height: u32) -> Subject {
    Subject {
        scene,
        size: Size::new(width, height),
    }
}

/// Pictures in docs/benchmarks.md.
pub(super) const SUBJECTS: [Subject; 7] = [
    subject("whitted", 320, 240),
    subject("four_spheres", 320, 240),
    subject("cylinders", 320, 240),
    subject("mirrors", 320, 240),
    subject("glass_indices", 320, 240),
    subject("sphereflake", 320, 240),
    subject("whitted", 128, 64),
];

/// Pictures with an instruction budget. They are small, because every `cargo xtask test` draws
/// them.
pub(super) const IN_BUDGET: [Subject; 3] = [
    subject("four_spheres", 320, 240),
    subject("whitted", 160, 120),
    subject("sphereflake", 80, 60),
];

impl Subject {
    pub(super) fn pixels(self) -> u64 {
        u64::from(self.size.width) * u64::from(self.size.height)
    }

    /// Returns the picture to draw in floating point. For cores without an FPU, this picture is
    /// smaller, because the full picture would take up to 10^11 instructions.
    pub(super) fn reduced_for_floats(self, core: Core) -> Self {
        let divisor = match self.scene {
            _ if core.has_fpu() => 1,
            "sphereflake" => 4,
            _ => 2,
        };
        Self {
            size: self.size / divisor,
            ..self
        }
    }
}

/// Writes the scene and the size, such as "whitted 320x240".
impl fmt::Display for Subject {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Size { width, height } = self.size;
        write!(f, "{} {width}x{height}", self.scene)
    }
}
