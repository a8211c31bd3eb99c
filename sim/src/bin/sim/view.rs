//! `sim view`: shows scenes in a window. Keys move the camera and change display options.
//!
//! ```text
//! window (SDL) ── keys ──> workbench ── frame, drawn in steps ──> window
//! watch (files) ── changes ──┘    └── status: text below the picture
//! ```

mod clock;
mod cycle;
mod frame;
mod keys;
mod options;
mod source;
mod status;
mod viewpoint;
mod watch;
mod window;
mod workbench;

pub(crate) use window::view;
