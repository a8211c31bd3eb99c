//! X screen: finds windows, presses keys, and reads pixels.

use std::thread::sleep;
use std::time::{Duration, Instant};

use x11rb::connection::Connection;
use x11rb::protocol::xproto::{
    AtomEnum, ConnectionExt, ImageFormat, InputFocus, KEY_PRESS_EVENT, KEY_RELEASE_EVENT, MapState,
    Window,
};
use x11rb::protocol::xtest::ConnectionExt as _;
use x11rb::rust_connection::RustConnection;

use crate::outcome::Outcome;
use crate::shot::Shot;

/// Time limit of each wait, long enough for a slow machine.
const TIMEOUT: Duration = Duration::from_secs(60);

/// Screen that the environment variable `DISPLAY` names.
pub(crate) struct Screen {
    connection: RustConnection,
    root: Window,
}

impl Screen {
    pub(crate) fn connect() -> Outcome<Self> {
        let (connection, number) = x11rb::connect(None)?;
        let root = connection.setup().roots[number].root;
        Ok(Self { connection, root })
    }

    /// Returns a handle to the window with a title. The window may open later, and SDL replaces it
    /// once after choosing a renderer.
    pub(crate) fn window<'s>(&'s self, title: &'s str) -> TitledWindow<'s> {
        TitledWindow {
            screen: self,
            title,
        }
    }

    fn find(&self, title: &str) -> Outcome<Option<Window>> {
        for window in self.connection.query_tree(self.root)?.reply()?.children {
            let (property, text) = (AtomEnum::WM_NAME, AtomEnum::ANY);
            let name = self
                .connection
                .get_property(false, window, property, text, 0, 64)?;
            let attributes = self.connection.get_window_attributes(window)?.reply()?;
            if name.reply()?.value == title.as_bytes() && attributes.map_state == MapState::VIEWABLE
            {
                return Ok(Some(window));
            }
        }
        Ok(None)
    }

    /// Returns the key code of an X key symbol.
    fn key(&self, symbol: u32) -> Outcome<u8> {
        let setup = self.connection.setup();
        let (first, last) = (setup.min_keycode, setup.max_keycode);
        let mapping = self
            .connection
            .get_keyboard_mapping(first, last - first + 1)?
            .reply()?;
        let symbols = mapping
            .keysyms
            .chunks(mapping.keysyms_per_keycode.max(1).into());
        let mut keys = (first..=last).zip(symbols);
        let found = keys.find(|(_, symbols)| symbols.first() == Some(&symbol));
        Ok(found.ok_or(format!("no key for {symbol:#x}"))?.0)
    }
}

/// Window that is found by its title at each use.
pub(crate) struct TitledWindow<'s> {
    screen: &'s Screen,
    title: &'s str,
}

impl TitledWindow<'_> {
    /// Presses and releases a key, given as a Latin-1 character or an X key symbol.
    ///
    /// Wait for a reaction before pressing the same key again: SDL takes two quick presses for a
    /// held key.
    pub(crate) fn press(&self, symbol: u32) -> Outcome {
        let key = self.screen.key(symbol)?;
        let connection = &self.screen.connection;
        let window = self.screen.find(self.title)?.ok_or("the window is gone")?;
        connection
            .set_input_focus(InputFocus::POINTER_ROOT, window, x11rb::CURRENT_TIME)?
            .check()?;
        for kind in [KEY_PRESS_EVENT, KEY_RELEASE_EVENT] {
            connection
                .xtest_fake_input(kind, key, 0, self.screen.root, 0, 0, 0)?
                .check()?;
        }
        Ok(())
    }

    /// Reads the pixels of the window; `None` if there is no such window.
    fn shot(&self) -> Outcome<Option<Shot>> {
        let Screen { connection, root } = self.screen;
        let Some(window) = self.screen.find(self.title)? else {
            return Ok(None);
        };
        let size = connection.get_geometry(window)?.reply()?;
        let at = connection
            .translate_coordinates(window, *root, 0, 0)?
            .reply()?;
        let (format, all) = (ImageFormat::Z_PIXMAP, !0);
        let (x, y, width, height) = (at.dst_x, at.dst_y, size.width, size.height);
        let image = connection
            .get_image(format, *root, x, y, width, height, all)?
            .reply()?;
        Ok(Some(Shot::new(width.into(), &image.data)))
    }

    /// Waits until a condition holds for the window's pixels. `what` describes it in the error.
    pub(crate) fn wait_for(&self, what: &str, is_shown: impl Fn(&Shot) -> bool) -> Outcome<Shot> {
        let deadline = Instant::now() + TIMEOUT;
        let mut last = None;
        while Instant::now() < deadline {
            // X returns an error if the window is replaced during the request.
            last = self.shot().unwrap_or_default();
            if let Some(shot) = last.take_if(|shot| is_shown(shot)) {
                return Ok(shot);
            }
            sleep(Duration::from_millis(20));
        }
        let file = last.ok_or("there is no window")?.save("failed")?;
        Err(format!(
            "timeout waiting for {what}; the last picture is in {}",
            file.display()
        )
        .into())
    }
}
