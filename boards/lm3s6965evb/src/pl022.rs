use core::convert::Infallible;

use embedded_hal::spi::{ErrorType, Operation, SpiDevice};

use crate::register::Registers;

const CONTROL_0: usize = 0x00;
const CONTROL_1: usize = 0x04;
const DATA: usize = 0x08;
const STATUS: usize = 0x0C;
const CLOCK_PRESCALE: usize = 0x10;

const EIGHT_BITS: u32 = 7;
const ENABLE: u32 = 1 << 1;
const RECEIVED: u32 = 1 << 2;

/// Polling driver of the Arm PL022 as SPI controller.
///
/// The PL022 drives its only chip select itself, so the driver implements [`SpiDevice`]
/// instead of `SpiBus`.
pub(crate) struct Pl022(Registers);

impl Pl022 {
    /// Initializes the SPI in mode 0. The most significant bit is sent first.
    ///
    /// The SPI clock is the system clock divided by `divisor`. The divisor must be even.
    pub(crate) fn new(registers: Registers, divisor: u8) -> Self {
        registers.write(CONTROL_1, 0);
        registers.write(CONTROL_0, EIGHT_BITS);
        registers.write(CLOCK_PRESCALE, u32::from(divisor));
        registers.write(CONTROL_1, ENABLE);
        Self(registers)
    }

    /// Sends a byte and returns the received byte.
    ///
    /// This function returns after the transfer is complete, so that the caller may change
    /// the D/C pin at once. The function reads every received byte, so the receive FIFO
    /// never overflows.
    fn exchange(&mut self, byte: u8) -> u8 {
        self.0.write(DATA, u32::from(byte));
        while self.0.read(STATUS) & RECEIVED == 0 {}
        self.0.read(DATA) as u8
    }
}

impl ErrorType for Pl022 {
    type Error = Infallible;
}

impl SpiDevice for Pl022 {
    fn transaction(&mut self, operations: &mut [Operation<'_, u8>]) -> Result<(), Infallible> {
        for operation in operations {
            match operation {
                Operation::Write(bytes) => {
                    for byte in *bytes {
                        self.exchange(*byte);
                    }
                }
                Operation::Read(bytes) => {
                    for byte in bytes.iter_mut() {
                        *byte = self.exchange(0);
                    }
                }
                Operation::Transfer(read, write) => {
                    for index in 0..read.len().max(write.len()) {
                        let received = self.exchange(write.get(index).copied().unwrap_or(0));
                        if let Some(byte) = read.get_mut(index) {
                            *byte = received;
                        }
                    }
                }
                Operation::TransferInPlace(bytes) => {
                    for byte in bytes.iter_mut() {
                        *byte = self.exchange(*byte);
                    }
                }
                // One clock cycle takes 83 ns at 12 MHz. A delay may be longer than
                // requested.
                Operation::DelayNs(nanoseconds) => cortex_m::asm::delay(*nanoseconds / 83 + 1),
            }
        }
        Ok(())
    }
}
