//! Scenes in flash, compiled by the build script, and one scene received over USB.

use heapless::Vec;
use whitted::DecodeError;
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
    /// Validates a received scene while another scene is drawn.
    validation_buffer: Buffer,
}

impl Scenes {
    /// Creates the list with the scenes in flash.
    pub(crate) const fn new() -> Self {
        Self {
            received: Vec::new(),
            validation_buffer: Buffer::new(),
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

    /// Stores a scene that arrived over USB and returns its index.
    ///
    /// Returns `None` if no scene arrived. An invalid scene is rejected and the previous
    /// scene is kept.
    pub(crate) fn receive(&mut self) -> Option<usize> {
        let is_received = usb::receive(|scene| {
            self.validation_buffer.decode(scene)?;
            self.received.clear();
            let result = self.received.extend_from_slice(scene);
            result.map_err(|_| DecodeError::Length)
        });
        is_received.then_some(SCENES.len())
    }
}
