//! The scenes: those in flash, compiled by `build.rs`, and one that came over USB.

use heapless::Vec;
use whitted::DecodeError;
use whitted::scene::SceneCounts;

use crate::usb;

include!(concat!(env!("OUT_DIR"), "/scenes.rs"));

/// Capacity for a scene that is sent over USB.
const SENT: SceneCounts = SceneCounts::EMPTY.objects(64).lights(8).materials(64);

/// Capacity for any scene.
const CAPACITY: SceneCounts = COUNTS.max(SENT);

/// Memory for any scene.
pub(crate) type Buffer = whitted::scene_buffer!(CAPACITY);

/// The scenes in flash, and after them the one that came last over USB.
pub(crate) struct Scenes {
    sent: Vec<u8, { usb::ROOM }>,
    /// Where is seen whether a scene can be drawn, while another is.
    trial: Buffer,
}

impl Scenes {
    /// Those in flash.
    pub(crate) const fn new() -> Self {
        Self {
            sent: Vec::new(),
            trial: Buffer::new(),
        }
    }

    /// A scene, compiled.
    pub(crate) fn get(&self, number: usize) -> &[u8] {
        SCENES.get(number).copied().unwrap_or(&self.sent)
    }

    pub(crate) fn count(&self) -> usize {
        SCENES.len() + usize::from(!self.sent.is_empty())
    }

    /// The number of a scene that came over USB, if one did. What cannot be
    /// drawn changes nothing.
    pub(crate) fn received(&mut self) -> Option<usize> {
        let is_there = usb::receive(|scene| {
            self.trial.decode(scene)?;
            self.sent.clear();
            let room = self.sent.extend_from_slice(scene);
            room.map_err(|_| DecodeError::Length)
        });
        is_there.then_some(SCENES.len())
    }
}
