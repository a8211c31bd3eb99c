//! Cycles per instruction, from the timings in the cores' technical reference
//! manuals: Cortex-M0+ (DDI 0484), table 3-1, with the multiplier of one cycle;
//! Cortex-M3 (DDI 0337), table 3-1; Cortex-M4 (DDI 0439), table 3-1.
//!
//! Those of the M3 and M4 hold without wait states. Where they give a range, the
//! middle is taken. Arm gives no timings for the M7 and the M33: the M4's are
//! scaled by what Arm says of the cores' CoreMark per MHz.

use super::fit::counted_as;
use super::mix::Mix;
use super::thumb::Class;
use crate::qemu::Core;

/// The average of a mix; that of a core which runs another's code is of the
/// other's.
pub(super) fn per_instruction(core: Core, mixes: &[(Core, Mix)]) -> f64 {
    let mut mixes = mixes.iter();
    let mix = mixes.find_map(|(of, mix)| (*of == counted_as(core)).then_some(mix));
    let price = match core {
        Core::M0 => m0,
        Core::M3 => m3,
        Core::M4f | Core::M7 | Core::M33 => m4,
    };
    mix.map_or(1.0, |mix| mix.mean(price)) * CORE_MARK_M4 / core_mark(core)
}

/// CoreMark per MHz of the M4, and of cores that are compared with it.
const CORE_MARK_M4: f64 = 3.42;

fn core_mark(core: Core) -> f64 {
    match core {
        Core::M7 => 5.01,
        Core::M33 => 4.02,
        // Whose timings are known.
        Core::M0 | Core::M3 | Core::M4f => CORE_MARK_M4,
    }
}

fn m0(class: Class, is_taken: bool) -> f64 {
    let refill = match class {
        Class::Call | Class::LoadMany(_) => 2,
        _ => 1,
    };
    let cycles = match class {
        Class::Load | Class::Store => 2,
        Class::LoadMany(count) | Class::StoreMany(count) => 1 + count,
        _ => 1,
    };
    f64::from(cycles + if is_taken { refill } else { 0 })
}

fn m3(class: Class, is_taken: bool) -> f64 {
    let more = match class {
        Class::MultiplyAdd => 1.0,
        // 3 to 5, and 4 to 7.
        Class::LongMultiply => 3.0,
        Class::LongMultiplyAdd => 4.5,
        _ => 0.0,
    };
    m4(class, is_taken) + more
}

fn m4(class: Class, is_taken: bool) -> f64 {
    // 1 to 3 to refill the pipeline.
    let refill = if is_taken { 2.0 } else { 0.0 };
    let cycles = match class {
        Class::Load => 2.0,
        Class::LoadMany(count) | Class::StoreMany(count) => f64::from(1 + count),
        // 2 to 12.
        Class::Divide => 7.0,
        _ => 1.0,
    };
    cycles + refill
}
