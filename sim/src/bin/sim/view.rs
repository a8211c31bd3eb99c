//! `sim view`: the simulator as a workbench.
//!
//! ```text
//! window (SDL) ── keys ──> workbench ── scene files, frame drawn in steps ──> window
//! watch (files) ── changed ──┘    └── status: what is said below the picture
//! ```

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
