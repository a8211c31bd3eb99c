//! `sim view`: the simulator as a workbench.
//!
//! ```text
//! window (SDL) ── keys ──> workbench ── scene files, frame drawn in steps ──> window
//! watch (files) ── changed ──┘    └── status: what is said below the picture
//! ```

#[cfg(feature = "window")]
mod cycle;
#[cfg(feature = "window")]
mod frame;
#[cfg(feature = "window")]
mod keys;
#[cfg(feature = "window")]
mod options;
#[cfg(feature = "window")]
mod source;
#[cfg(feature = "window")]
mod status;
#[cfg(feature = "window")]
mod viewpoint;
#[cfg(feature = "window")]
mod watch;
#[cfg(feature = "window")]
mod window;
#[cfg(not(feature = "window"))]
mod without_window;
#[cfg(feature = "window")]
mod workbench;

#[cfg(feature = "window")]
pub(crate) use window::view;
#[cfg(not(feature = "window"))]
pub(crate) use without_window::view;
