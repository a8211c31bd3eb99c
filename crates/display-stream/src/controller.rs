use crate::address::AddressOrder;
use crate::command::{self, parameter_count};
use crate::error::{BlankError, StreamError};
use crate::memory::{Cursor, Memory, Range};
use crate::panel::Panel;
use crate::picture::Picture;
use crate::pixel;

/// Value of the COLMOD register after a reset of an ST7789 or an ILI9341. This value
/// selects 18 bits per pixel.
const COLMOD_AT_RESET: u8 = 0x66;

/// A byte on the SPI bus, tagged with the level of the D/C pin.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Byte {
    /// Command opcode, sent while D/C is low.
    Command(u8),
    /// Parameter or half of a 16-bit pixel, sent while D/C is high.
    Data(u8),
}

impl Byte {
    /// Creates a byte. `is_data` is true if the D/C pin is high.
    pub fn new(is_data: bool, byte: u8) -> Self {
        if is_data {
            Self::Data(byte)
        } else {
            Self::Command(byte)
        }
    }
}

/// Model of a display controller that executes SPI traffic byte by byte.
///
/// A byte that causes an error does not change the picture. After such an error, the
/// controller accepts the next byte.
#[derive(Clone, Debug)]
pub struct Controller {
    panel: Panel,
    memory: Memory,
    state: State,
    /// Command that received data bytes belong to.
    command: Option<u8>,
    /// Parameter bytes of `command` that have arrived, or the first byte of a pixel.
    received: Vec<u8>,
}

/// Registers of the controller. Commands set these registers, and SWRESET resets them.
#[derive(Clone, Debug)]
struct State {
    columns: Range,
    rows: Range,
    /// Address of the next pixel. The cursor is `None` until the command RAMWR starts a
    /// write into the window.
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
    /// Creates a controller in the state that it has after power-on and a hardware reset.
    pub fn new(panel: Panel) -> Self {
        Self {
            panel,
            memory: Memory::new(panel.memory),
            state: State::new(&panel),
            command: None,
            received: Vec::with_capacity(4),
        }
    }

    /// Executes bytes until one causes an error.
    ///
    /// # Errors
    /// Returns the error of the first invalid byte.
    pub fn receive_all(
        &mut self,
        bytes: impl IntoIterator<Item = Byte>,
    ) -> Result<(), StreamError> {
        bytes.into_iter().try_for_each(|byte| self.receive(byte))
    }

    /// Executes one byte.
    ///
    /// # Errors
    /// Returns an error if the byte is invalid, or if it completes an invalid command
    /// or pixel.
    pub fn receive(&mut self, byte: Byte) -> Result<(), StreamError> {
        match byte {
            Byte::Command(command) => self.receive_command(command),
            Byte::Data(data) => self.receive_data(data),
        }
    }

    /// Returns the picture that the panel shows now.
    ///
    /// # Errors
    /// Returns the reason why the panel shows no picture.
    pub fn picture(&self) -> Result<Picture, BlankError> {
        let panel = &self.panel;
        if self.state.is_asleep {
            return Err(BlankError::Asleep);
        }
        if !self.state.is_on {
            return Err(BlankError::Off);
        }
        let is_negative = self.state.is_inverted != panel.is_inverted;
        let is_swapped = pixel::is_red_blue_swapped(self.state.madctl, panel.madctl);
        let mut never_written = None;
        let picture = Picture::from_fn(panel.size(), |at| {
            let pixel = self.memory.get(panel.memory_position(at));
            if pixel.is_none() {
                never_written.get_or_insert(at);
            }
            pixel::visible_color(pixel.unwrap_or_default(), is_swapped, is_negative)
        });
        match never_written {
            Some(at) => Err(BlankError::NeverWritten { at }),
            None => Ok(picture),
        }
    }

    fn receive_command(&mut self, command: u8) -> Result<(), StreamError> {
        let previous = self.command.replace(command);
        // A command discards a pixel of which only one byte has arrived, as real
        // controllers do.
        let received = std::mem::take(&mut self.received).len();
        if let Some(previous) = previous
            && received < parameter_count(previous)
        {
            self.command = None;
            return Err(StreamError::Interrupted {
                command: previous,
                received,
                expected: parameter_count(previous),
            });
        }
        self.execute(command)
    }

    /// Executes the part of a command that needs no parameters.
    fn execute(&mut self, command: u8) -> Result<(), StreamError> {
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
            command::FIRST_MANUFACTURER.. => {}
            _ => return Err(StreamError::NotModeled { command }),
        }
        Ok(())
    }

    fn receive_data(&mut self, data: u8) -> Result<(), StreamError> {
        let Some(command) = self.command else {
            return Err(StreamError::NoCommand { data });
        };
        match command {
            command::RAMWR | command::RAMWRC => self.receive_pixel_byte(data),
            _ if self.received.len() < parameter_count(command) => {
                self.received.push(data);
                self.apply_parameters(command)
            }
            _ => Ok(()),
        }
    }

    /// Applies the parameters of a command once all have arrived.
    fn apply_parameters(&mut self, command: u8) -> Result<(), StreamError> {
        let state = &mut self.state;
        match (command, self.received.as_slice()) {
            (command::CASET, &[a, b, c, d]) => {
                state.columns = parse_range(command, [a, b, c, d])?;
                state.cursor = None;
            }
            (command::RASET, &[a, b, c, d]) => {
                state.rows = parse_range(command, [a, b, c, d])?;
                state.cursor = None;
            }
            (command::MADCTL, &[madctl]) => state.madctl = madctl,
            (command::COLMOD, &[colmod]) => state.colmod = colmod,
            _ => {}
        }
        Ok(())
    }

    fn receive_pixel_byte(&mut self, data: u8) -> Result<(), StreamError> {
        let State { colmod, madctl, .. } = self.state;
        // Bits 0 to 2 of COLMOD select the pixel format of the SPI interface. The value 5
        // means 16 bits per pixel. Bits 4 to 6 apply only to the parallel RGB interface.
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
        self.memory
            .write(cursor, AddressOrder::from_madctl(madctl), pixel)
    }
}

fn parse_range(command: u8, [a, b, c, d]: [u8; 4]) -> Result<Range, StreamError> {
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
