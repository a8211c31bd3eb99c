/// A peripheral's 32-bit registers.
#[derive(Clone, Copy)]
pub(crate) struct Registers(usize);

impl Registers {
    /// The registers from `base` on.
    ///
    /// # Safety
    ///
    /// A peripheral must lie at `base`, and nothing else may use the registers
    /// that are used through this value.
    pub(crate) const unsafe fn at(base: usize) -> Self {
        Self(base)
    }

    /// Reads the register at `offset`.
    pub(crate) fn read(self, offset: usize) -> u32 {
        // SAFETY: by the contract of `at` this is a register.
        unsafe { core::ptr::with_exposed_provenance::<u32>(self.0 + offset).read_volatile() }
    }

    /// Writes the register at `offset`.
    pub(crate) fn write(self, offset: usize, value: u32) {
        // SAFETY: by the contract of `at` this is a register.
        unsafe {
            core::ptr::with_exposed_provenance_mut::<u32>(self.0 + offset).write_volatile(value)
        }
    }

    /// Sets bits of the register at `offset`.
    pub(crate) fn set(self, offset: usize, bits: u32) {
        self.write(offset, self.read(offset) | bits);
    }
}
