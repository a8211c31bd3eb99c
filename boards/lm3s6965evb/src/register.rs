/// Handle for the 32-bit registers of a peripheral.
#[derive(Clone, Copy)]
pub(crate) struct Registers(usize);

impl Registers {
    /// Creates a handle for the registers at `base`.
    ///
    /// # Safety
    ///
    /// `base` must be the address of a peripheral. No other code may use the registers that
    /// this handle reads or writes.
    pub(crate) const unsafe fn at(base: usize) -> Self {
        Self(base)
    }

    /// Reads the register at `offset`.
    pub(crate) fn read(self, offset: usize) -> u32 {
        // SAFETY: the caller of `at` guarantees that a register is at this address.
        unsafe { core::ptr::with_exposed_provenance::<u32>(self.0 + offset).read_volatile() }
    }

    /// Writes the register at `offset`.
    pub(crate) fn write(self, offset: usize, value: u32) {
        // SAFETY: the caller of `at` guarantees that a register is at this address.
        unsafe {
            core::ptr::with_exposed_provenance_mut::<u32>(self.0 + offset).write_volatile(value)
        }
    }

    /// Sets bits of the register at `offset`.
    pub(crate) fn set(self, offset: usize, bits: u32) {
        self.write(offset, self.read(offset) | bits);
    }
}
