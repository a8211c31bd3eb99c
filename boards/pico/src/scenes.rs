//! The scenes in flash, compiled by `build.rs`.

use whitted::{Camera, Real, SceneBuffer, Vec3};

/// A scene in flash.
pub(crate) struct FlashScene {
    pub(crate) compiled: &'static [u8],
    /// As it was written down, to be moved from.
    pub(crate) camera: Camera,
}

/// All of them.
pub(crate) static SCENES: &[FlashScene] = include!(concat!(env!("OUT_DIR"), "/scenes.rs"));

/// Room for any one of them.
pub(crate) type Buffer = SceneBuffer<{ COUNTS[0] }, { COUNTS[1] }, { COUNTS[2] }>;

/// The most objects, lights and materials that one of them has.
const COUNTS: [usize; 3] = {
    let mut most = [0; 3];
    let mut scene = 0;
    // Constants are computed without iterators.
    while scene < SCENES.len() {
        let counts = whitted::counts(SCENES[scene].compiled);
        let mut kind = 0;
        while kind < counts.len() {
            if counts[kind] > most[kind] {
                most[kind] = counts[kind];
            }
            kind += 1;
        }
        scene += 1;
    }
    most
};
