use cortex_m::peripheral::{SYST, syst::SystClkSource};

/// Mask for the values of SysTick, which is a 24-bit counter.
const MASK: u32 = 0x00FF_FFFF;

/// Counts instructions with SysTick, under QEMU with `-icount shift=0`.
///
/// With `-icount shift=0`, each instruction takes one nanosecond of virtual time, so the
/// count is equal in every run. On a real chip the stopwatch measures nanoseconds.
pub struct Stopwatch {
    /// The stopwatch owns the timer, so that no other code can reconfigure it.
    _systick: SYST,
    nanoseconds_per_tick: u32,
    /// Value of SysTick at the last lap. SysTick counts down.
    last: u32,
    ticks: u64,
}

impl Stopwatch {
    /// Starts a stopwatch. `nanoseconds_per_tick` is the period of the core clock.
    pub fn new(mut systick: SYST, nanoseconds_per_tick: u32) -> Self {
        systick.set_clock_source(SystClkSource::Core);
        systick.set_reload(MASK);
        systick.clear_current();
        systick.enable_counter();
        Self {
            _systick: systick,
            nanoseconds_per_tick,
            last: SYST::get_current(),
            ticks: 0,
        }
    }

    /// Resets the count to zero.
    pub fn restart(&mut self) {
        self.last = SYST::get_current();
        self.ticks = 0;
    }

    /// Adds the time since the last lap.
    ///
    /// A lap must be shorter than 2^24 ticks, the range of SysTick. Depending on the clock,
    /// that is 0.67 to 1.3 billion instructions.
    pub fn lap(&mut self) {
        let now = SYST::get_current();
        self.ticks += u64::from(self.last.wrapping_sub(now) & MASK);
        self.last = now;
    }

    /// Returns the number of instructions from the start to the last lap.
    pub fn instructions(&self) -> u64 {
        self.ticks * u64::from(self.nanoseconds_per_tick)
    }
}
