use core::fmt;

use cobs::{DecodeResult, DecoderState};
use heapless::Vec;

use crate::frame::checksum;

/// Decodes frames byte by byte into a buffer of `CAPACITY` bytes.
///
/// A scene may have up to `CAPACITY - 6` bytes, because the ticket and the checksum take 6
/// bytes. The receiver has no timer, so the caller must detect stalled transfers and call
/// [`forget`](Self::forget).
#[derive(Debug)]
pub struct Receiver<const CAPACITY: usize> {
    decoder: DecoderState,
    bytes: Vec<u8, CAPACITY>,
    progress: Progress,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Progress {
    /// No byte has arrived since the last frame.
    Waiting,
    /// Part of a frame has arrived.
    Receiving,
    /// The current frame is longer than the buffer. The receiver ignores the rest of the
    /// frame.
    TooLong,
    /// The buffer holds a complete message.
    Received,
}

/// Message from the host: a scene and its ticket.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Message<'m> {
    /// The number that the host chose for this transfer. The board's answer must repeat it.
    pub ticket: u16,
    /// The compiled scene. Its checksum is correct, but its content is not validated.
    pub scene: &'m [u8],
}

/// The reason why a transfer failed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ReceiveError {
    /// Bytes were changed, lost or added, or the data is not a frame.
    Damaged,
    /// The scene exceeds the capacity of the receiver.
    TooLong {
        /// Largest accepted length of a scene, in bytes.
        max_len: usize,
    },
    /// The transfer stopped before the end of the frame.
    Stalled,
}

impl fmt::Display for ReceiveError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Damaged => f.write_str("data damaged in transit"),
            Self::TooLong { max_len } => write!(f, "scene exceeds the limit of {max_len} bytes"),
            Self::Stalled => f.write_str("transfer stopped before the end"),
        }
    }
}

impl core::error::Error for ReceiveError {}

impl<const CAPACITY: usize> Default for Receiver<CAPACITY> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const CAPACITY: usize> Receiver<CAPACITY> {
    /// Creates an empty receiver.
    pub const fn new() -> Self {
        Self {
            decoder: DecoderState::Idle,
            bytes: Vec::new(),
            progress: Progress::Waiting,
        }
    }

    /// Processes one byte. If this byte ends a frame, returns the result of the transfer.
    ///
    /// While the receiver holds a message, it ignores all bytes. Call
    /// [`forget`](Self::forget) to receive the next frame.
    pub fn receive(&mut self, byte: u8) -> Option<Result<(), ReceiveError>> {
        if self.progress == Progress::Received {
            return None;
        }
        match self.decoder.feed(byte) {
            Ok(DecodeResult::NoData) => None,
            Ok(DecodeResult::DataStart) => {
                self.bytes.clear();
                self.progress = Progress::Receiving;
                None
            }
            Ok(DecodeResult::DataContinue(byte)) => {
                if self.bytes.push(byte).is_err() {
                    self.progress = Progress::TooLong;
                }
                None
            }
            Ok(DecodeResult::DataComplete) => Some(self.end()),
            Err(_) => Some(Err(self.reset(ReceiveError::Damaged))),
        }
    }

    /// Returns the received message, if there is one.
    pub fn message(&self) -> Option<Message<'_>> {
        let is_complete = self.progress == Progress::Received;
        self.parts()
            .filter(|_| is_complete)
            .map(|(message, _)| message)
    }

    /// Discards the message or the incomplete frame in the buffer.
    ///
    /// Returns an error if a frame was incomplete.
    pub fn forget(&mut self) -> Option<ReceiveError> {
        let is_incomplete = matches!(self.progress, Progress::Receiving | Progress::TooLong);
        self.decoder = DecoderState::Idle;
        let error = self.reset(ReceiveError::Stalled);
        is_incomplete.then_some(error)
    }

    /// Verifies the checksum of a complete frame.
    fn end(&mut self) -> Result<(), ReceiveError> {
        let is_valid = self.parts().is_some_and(|(message, sum)| {
            checksum(&[&message.ticket.to_le_bytes(), message.scene]) == sum
        });
        if is_valid && self.progress == Progress::Receiving {
            self.progress = Progress::Received;
            Ok(())
        } else {
            Err(self.reset(ReceiveError::Damaged))
        }
    }

    /// Clears the buffer and returns `error`, or `TooLong` if the frame was too long.
    fn reset(&mut self, error: ReceiveError) -> ReceiveError {
        let was_too_long = self.progress == Progress::TooLong;
        self.bytes.clear();
        self.progress = Progress::Waiting;
        match was_too_long {
            true => ReceiveError::TooLong {
                max_len: CAPACITY.saturating_sub(crate::frame::OVERHEAD),
            },
            false => error,
        }
    }

    /// Splits the buffer into the message and the received checksum. Does not verify the
    /// checksum.
    fn parts(&self) -> Option<(Message<'_>, u32)> {
        let (ticket, rest) = self.bytes.split_first_chunk()?;
        let (scene, checksum) = rest.split_last_chunk()?;
        let ticket = u16::from_le_bytes(*ticket);
        Some((Message { ticket, scene }, u32::from_le_bytes(*checksum)))
    }
}
