//! Scenes in flash, compiled by the build script, and one scene received over USB.

use heapless::Vec;
use whitted::scene::SceneCounts;

use crate::usb;

// The included file defines two items. `SCENES` is a list of compiled scenes. `COUNTS` is a
// buffer capacity that is large enough for each of these scenes.
include!(concat!(env!("OUT_DIR"), "/scenes.rs"));

/// Largest number of objects, lights and materials in a scene received over USB.
const RECEIVED_COUNTS: SceneCounts = SceneCounts::EMPTY.objects(64).lights(8).materials(64);

/// Capacity that fits every scene, whether it is in flash or received over USB.
const CAPACITY: SceneCounts = COUNTS.max(RECEIVED_COUNTS);

/// Memory for a prepared scene, which may come from flash or over USB.
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

    /// Returns the compiled scene at `index`. An index after the last scene in flash
    /// returns the scene that was received over USB.
    pub(crate) fn get(&self, index: usize) -> &[u8] {
        SCENES.get(index).copied().unwrap_or(&self.received)
    }

    /// Returns the number of scenes, including the received scene if there is one.
    pub(crate) fn count(&self) -> usize {
        SCENES.len() + usize::from(!self.received.is_empty())
    }

    /// Moves the scene from the USB receiver to the end of the list and returns its index.
    ///
    /// The new scene overwrites the previously received scene. No prepared scene may still
    /// borrow the previous scene.
    pub(crate) fn store_received(&mut self) -> usize {
        usb::take(|scene| {
            self.received.clear();
            // The list `received` has the capacity of the USB receiver, so every received
            // scene fits into it.
            _ = self.received.extend_from_slice(scene);
        });
        SCENES.len()
    }
}
