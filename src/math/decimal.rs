//! Formatting of the numbers of a scene as decimal text.
//!
//! The `Display` implementation of the `fixed` crate contains panic paths. Firmware must not
//! contain any, so the library uses this file instead.

use core::fmt::{self, Display, Formatter, Write};

use super::format::Real;

/// Displays a number with the fewest decimals that identify it (Steele and White, 1990).
pub(crate) struct Decimal(pub(crate) Real);

impl Display for Decimal {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        if self.0 < 0 {
            f.write_char('-')?;
        }
        let bits = self.0.to_bits().unsigned_abs();
        write!(f, "{}", bits >> 32)?;
        if bits as u32 != 0 {
            f.write_char('.')?;
            decimals(bits as u32, f)?;
        }
        Ok(())
    }
}

/// Writes the decimals of a fraction above 0, given as `U0F32`.
fn decimals(fraction: u32, f: &mut Formatter<'_>) -> fmt::Result {
    // `rest` is the part of the fraction that remains to be written. `near` is half of 2^-32, the
    // resolution of the fraction. Both variables are in units of 2^-33 and are multiplied by ten
    // for each digit. The loop ends when the digits written differ from the fraction by less than
    // `near`.
    const ONE: u64 = 1 << 33;
    let mut rest = u64::from(fraction) << 1;
    let mut near = 1;
    loop {
        (rest, near) = (10 * rest, 10 * near);
        let digit = (rest >> 33) as u8;
        rest &= ONE - 1;
        let (below, above) = (rest < near, ONE - rest < near);
        if below || above {
            let up = above && (!below || rest > ONE / 2);
            return f.write_char(char::from(b'0' + digit + u8::from(up)));
        }
        f.write_char(char::from(b'0' + digit))?;
    }
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::*;
    use std::string::ToString;

    #[test]
    fn matches_display_of_the_fixed_crate() {
        let edges = [0, 1, 2, -1, 1 << 31, 1 << 32, i64::MAX, i64::MIN, 4295];
        let mut state = 1_i64;
        let random = (0..if cfg!(miri) { 200 } else { 100_000 }).map(|shift| {
            state ^= state << 13;
            state ^= ((state as u64) >> 7) as i64;
            state ^= state << 17;
            state >> (shift % 60)
        });
        for number in edges.into_iter().chain(random).map(Real::from_bits) {
            assert_eq!(Decimal(number).to_string(), number.to_string());
        }
    }
}
