use cortex_m::peripheral::{SYST, syst::SystClkSource};

/// SysTick's width.
const MASK: u32 = 0x00FF_FFFF;

/// Counts instructions, on a QEMU started with `-icount shift=0`.
///
/// There an instruction takes one nanosecond, so SysTick, whose ticks have a
/// fixed length, counts instructions, and counts the same in every run. On a
/// chip it measures nanoseconds, as exactly as its clock runs.
pub struct Stopwatch {
    /// Held so that nobody else sets it.
    _systick: SYST,
    nanoseconds_per_tick: u32,
    /// Where SysTick, which counts down, stood at the last lap.
    last: u32,
    ticks: u64,
}

impl Stopwatch {
    /// A stopwatch, started; `nanoseconds_per_tick` is the core clock's period.
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

    /// Begins anew.
    pub fn restart(&mut self) {
        self.last = SYST::get_current();
        self.ticks = 0;
    }

    /// Adds what has passed since the last lap. SysTick has but 24 bits, so a
    /// lap may take 2^24 ticks at most: about 0.7 to 1.3 G instructions.
    pub fn lap(&mut self) {
        let now = SYST::get_current();
        self.ticks += u64::from(self.last.wrapping_sub(now) & MASK);
        self.last = now;
    }

    /// Instructions from the start to the last lap.
    pub fn instructions(&self) -> u64 {
        self.ticks * u64::from(self.nanoseconds_per_tick)
    }
}
