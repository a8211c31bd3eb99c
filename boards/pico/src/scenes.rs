//! Scenes in flash, compiled by the build script, and one scene received over USB.

use heapless::Vec;
use whitted::scene::SceneCounts;

use crate::usb;

// Defines `SCENES`, the compiled scenes, and `COUNTS`, the capacity that fits each of them.
include!(concat!(env!("OUT_DIR"), "/scenes.rs"));

/// Capacity for scenes received over USB.
const RECEIVED_COUNTS: SceneCounts = SceneCounts::EMPTY.objects(64).lights(8).materials(64);

/// Capacity for any scene.
const CAPACITY: SceneCounts = COUNTS.max(RECEIVED_COUNTS);

/// Memory for any scene.
pub(crate) type Buffer = whitted::scene_buffer!(CAPACITY);

/// List of the scenes in flash, followed by the last scene received over USB.
pub(crate) struct Scenes {
    received: Vec<u8, { usb::CAPACITY }>,
}

impl Scenes {
    /// Creates the list with the scenes in flash.
    pub(crate) const fn new() -> Self {
        Self {
            received: Vec::new(),
        }
    }

    /// Returns a compiled scene. Indices past the flash select the received scene.
    pub(crate) fn get(&self, index: usize) -> &[u8] {
        SCENES.get(index).copied().unwrap_or(&self.received)
    }

    /// Returns the number of scenes.
    pub(crate) fn count(&self) -> usize {
        SCENES.len() + usize::from(!self.received.is_empty())
    }

    /// Stores the scene in the USB receiver and returns its index.
    ///
    /// The scene replaces the previous received scene, so no prepared scene may borrow it.
    pub(crate) fn store_received(&mut self) -> usize {
        usb::take(|scene| {
            self.received.clear();
            // The capacity equals that of the receiver, so the scene always fits.
            _ = self.received.extend_from_slice(scene);
        });
        SCENES.len()
    }
}
