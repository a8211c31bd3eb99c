#![no_std]
//! A protocol that sends compiled scenes to a board over a serial line.
//!
//! The host sends a scene as a [`frame`]. A [`Receiver`] on the board decodes the
//! frame byte by byte. The board replies with an [`Answer`], a line of text. The
//! frame format is:
//!
//! ```text
//! 0  COBS(ticket: u16  scene  CRC-32 of both)  0
//! ```
//!
//! Integers are little-endian. [COBS](cobs) encodes the payload without zeros, so a
//! zero always marks the start or end of a frame. After lost or extra bytes, the
//! receiver continues at the next zero. The ticket is a number that the host chooses.
//! The board's answer repeats the ticket, so the host can ignore answers to earlier
//! transfers.
//!
//! ```
//! use scene_serial::{Answer, Receiver, frame, frame_len};
//!
//! let mut bytes = [0; frame_len(5)];
//! let frame = frame(7, b"scene", &mut bytes).unwrap();
//!
//! let mut receiver = Receiver::<64>::new();
//! let received = frame.iter().filter_map(|byte| receiver.receive(*byte)).next();
//! assert_eq!(received, Some(Ok(())));
//! let message = receiver.message().unwrap();
//! assert_eq!((message.ticket, message.scene), (7, &b"scene"[..]));
//!
//! let answer = Answer::Shown { ticket: message.ticket };
//! assert_eq!(Answer::parse("shown 0007"), Some(answer));
//! ```

mod answer;
mod frame;
mod receiver;

pub use answer::Answer;
pub use frame::{frame, frame_len};
pub use receiver::{Message, ReceiveError, Receiver};
