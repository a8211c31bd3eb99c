use std::fmt;
use std::path::PathBuf;

use crate::qemu::{Arithmetic, Core};
use crate::root;

/// A picture to be measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Subject {
    pub(crate) scene: &'static str,
    pub(crate) width: u32,
    pub(crate) height: u32,
}

const fn subject(scene: &'static str, width: u32, height: u32) -> Subject {
    Subject {
        scene,
        width,
        height,
    }
}

/// Those of the benchmark.
pub(crate) const SUBJECTS: [Subject; 7] = [
    subject("whitted", 320, 240),
    subject("four_spheres", 320, 240),
    subject("cylinders", 320, 240),
    subject("mirrors", 320, 240),
    subject("glass_indices", 320, 240),
    subject("sphereflake", 320, 240),
    subject("whitted", 128, 64),
];

/// Those of the budget: small, as every test run counts them.
pub(crate) const IN_BUDGET: [Subject; 3] = [
    subject("four_spheres", 320, 240),
    subject("whitted", 160, 120),
    subject("sphereflake", 80, 60),
];

impl Subject {
    /// The scene file.
    pub(crate) fn file(self) -> PathBuf {
        root()
            .join("scenes")
            .join(self.scene)
            .with_extension("toml")
    }

    pub(crate) fn size(self) -> String {
        format!("{}x{}", self.width, self.height)
    }

    pub(crate) fn pixels(self) -> u64 {
        u64::from(self.width) * u64::from(self.height)
    }

    /// By how much the sides are divided, so that software floats, which take
    /// up to 10^11 instructions a frame, draw in time.
    pub(crate) fn reduction(self, arithmetic: Arithmetic, core: Core) -> u32 {
        if arithmetic == Arithmetic::Fixed || core.has_fpu() {
            1
        } else if self.scene == "sphereflake" {
            4
        } else {
            2
        }
    }

    /// Smaller, with sides divided by this.
    pub(crate) fn reduced(self, by: u32) -> Self {
        Self {
            width: self.width / by,
            height: self.height / by,
            ..self
        }
    }
}

impl fmt::Display for Subject {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}x{}", self.scene, self.width, self.height)
    }
}
