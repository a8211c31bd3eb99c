use crate::address::AddressOrder;
use crate::command::{self, parameters};
use crate::error::{BlankError, StreamError};
use crate::memory::{Cursor, Memory, Range};
use crate::panel::Panel;
use crate::picture::Picture;
use crate::pixel;

/// 18 bits a pixel: what both controllers start with.
const COLMOD_AT_RESET: u8 = 0x66;

/// A byte, and the level of the D/C pin at it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Byte {
    /// D/C is low.
    Command(u8),
    /// D/C is high: a parameter, or half a pixel.
    Data(u8),
}

impl Byte {
    /// The byte, and whether D/C is high.
    pub fn new(is_data: bool, byte: u8) -> Self {
        if is_data {
            Self::Data(byte)
        } else {
            Self::Command(byte)
        }
    }
}

/// A display controller that takes what is sent, byte by byte.
///
/// A byte that it complains about has changed nothing; it can go on with the next.
#[derive(Clone, Debug)]
pub struct Controller {
    panel: Panel,
    memory: Memory,
    state: State,
    /// What data is for.
    command: Option<u8>,
    /// Parameters of that command, or half a pixel.
    received: Vec<u8>,
}

/// What commands set, and a reset brings back.
#[derive(Clone, Debug)]
struct State {
    columns: Range,
    rows: Range,
    /// Where the next pixel goes, once pixels have started in this window.
    cursor: Option<Cursor>,
    madctl: u8,
    colmod: u8,
    is_asleep: bool,
    is_on: bool,
    is_inverted: bool,
}

impl State {
    fn new(panel: &Panel) -> Self {
        Self {
            columns: Range::all(panel.memory.width),
            rows: Range::all(panel.memory.height),
            cursor: None,
            madctl: 0,
            colmod: COLMOD_AT_RESET,
            is_asleep: true,
            is_on: false,
            is_inverted: false,
        }
    }
}

impl Controller {
    /// A controller after power-on and its hardware's reset.
    pub fn new(panel: Panel) -> Self {
        Self {
            panel,
            memory: Memory::new(panel.memory),
            state: State::new(&panel),
            command: None,
            received: Vec::with_capacity(4),
        }
    }

    /// Takes the bytes until one is wrong.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn receive_all(
        &mut self,
        bytes: impl IntoIterator<Item = Byte>,
    ) -> Result<(), StreamError> {
        bytes.into_iter().try_for_each(|byte| self.receive(byte))
    }

    /// Takes a byte.
    ///
    /// # Errors
    /// What is wrong with it, or with what came before it and is now complete.
    pub fn receive(&mut self, byte: Byte) -> Result<(), StreamError> {
        match byte {
            Byte::Command(command) => self.command(command),
            Byte::Data(data) => self.data(data),
        }
    }

    /// What a person sees now.
    ///
    /// # Errors
    /// Why there is nothing to be seen.
    pub fn picture(&self) -> Result<Picture, BlankError> {
        let panel = &self.panel;
        if self.state.is_asleep {
            return Err(BlankError::Asleep);
        }
        if !self.state.is_on {
            return Err(BlankError::Off);
        }
        let is_negative = self.state.is_inverted != panel.is_inverted;
        let is_swapped = pixel::is_swapped(self.state.madctl, panel.upright);
        let mut never_written = None;
        let picture = Picture::from_fn(panel.size(), |at| {
            let pixel = self.memory.at(panel.place(at));
            if pixel.is_none() {
                never_written.get_or_insert(at);
            }
            pixel::shown(pixel.unwrap_or_default(), is_swapped, is_negative)
        });
        match never_written {
            Some(at) => Err(BlankError::NeverWritten { at }),
            None => Ok(picture),
        }
    }

    fn command(&mut self, command: u8) -> Result<(), StreamError> {
        let before = self.command.replace(command);
        // Half a pixel is lost, as it is on the controllers.
        let received = std::mem::take(&mut self.received).len();
        if let Some(before) = before
            && received < parameters(before)
        {
            self.command = None;
            return Err(StreamError::Interrupted {
                command: before,
                received,
                expected: parameters(before),
            });
        }
        self.start(command)
    }

    /// What a command does before it has parameters.
    fn start(&mut self, command: u8) -> Result<(), StreamError> {
        let state = &mut self.state;
        match command {
            command::SWRESET => *state = State::new(&self.panel),
            command::SLPIN => state.is_asleep = true,
            command::SLPOUT => state.is_asleep = false,
            command::INVOFF => state.is_inverted = false,
            command::INVON => state.is_inverted = true,
            command::DISPOFF => state.is_on = false,
            command::DISPON => state.is_on = true,
            command::RAMWR => state.cursor = Some(Cursor::new(state.columns, state.rows)),
            command::RAMWRC if state.cursor.is_none() => {
                return Err(StreamError::NothingToContinue);
            }
            command::RAMWRC | command::CASET | command::RASET => {}
            command::MADCTL | command::COLMOD => {}
            command::NOP | command::NORON | command::IDMOFF | command::GAMSET => {}
            command::TEOFF | command::TEON | command::STE => {}
            command::WRDISBV | command::WRCTRLD | command::WRCACE | command::WRCABCMB => {}
            command::FIRST_OF_MAKER.. => {}
            _ => return Err(StreamError::NotModeled { command }),
        }
        Ok(())
    }

    fn data(&mut self, data: u8) -> Result<(), StreamError> {
        let Some(command) = self.command else {
            return Err(StreamError::NoCommand { data });
        };
        match command {
            command::RAMWR | command::RAMWRC => self.half_pixel(data),
            _ if self.received.len() < parameters(command) => {
                self.received.push(data);
                self.parameter(command)
            }
            _ => Ok(()),
        }
    }

    /// What a command does once its parameters are complete.
    fn parameter(&mut self, command: u8) -> Result<(), StreamError> {
        let state = &mut self.state;
        match (command, self.received.as_slice()) {
            (command::CASET, &[a, b, c, d]) => {
                state.columns = range(command, [a, b, c, d])?;
                state.cursor = None;
            }
            (command::RASET, &[a, b, c, d]) => {
                state.rows = range(command, [a, b, c, d])?;
                state.cursor = None;
            }
            (command::MADCTL, &[madctl]) => state.madctl = madctl,
            (command::COLMOD, &[colmod]) => state.colmod = colmod,
            _ => {}
        }
        Ok(())
    }

    fn half_pixel(&mut self, data: u8) -> Result<(), StreamError> {
        let State { colmod, madctl, .. } = self.state;
        // The upper half is for displays without a controller of their own.
        if colmod & 7 != 5 {
            return Err(StreamError::PixelFormat { colmod });
        }
        let Some(first) = self.received.pop() else {
            self.received.push(data);
            return Ok(());
        };
        let Some(cursor) = &mut self.state.cursor else {
            return Err(StreamError::NothingToContinue);
        };
        let pixel = u16::from_be_bytes([first, data]);
        self.memory.write(cursor, AddressOrder::of(madctl), pixel)
    }
}

fn range(command: u8, [a, b, c, d]: [u8; 4]) -> Result<Range, StreamError> {
    let (first, last) = (u16::from_be_bytes([a, b]), u16::from_be_bytes([c, d]));
    if last < first {
        return Err(StreamError::Reversed {
            command,
            first,
            last,
        });
    }
    Ok(Range { first, last })
}
