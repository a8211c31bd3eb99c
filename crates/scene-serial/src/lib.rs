#![no_std]
//! Compiled scenes over a serial line, and what boards answer.
//!
//! A scene travels as a [`frame`], which a [`Receiver`] on the board takes byte by
//! byte; an [`Answer`] comes back as a line of text:
//!
//! ```text
//! 0  COBS(ticket: u16  scene  CRC-32 of both)  0
//! ```
//!
//! Integers are little-endian. [COBS](cobs) leaves no zero inside of a frame, so
//! whatever was lost or added before it, a frame begins at its first zero. The
//! ticket is a number of the host's, by which it knows the answer from one to
//! somebody before it.
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
pub use receiver::{Broken, Message, Receiver};
