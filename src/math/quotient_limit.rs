use long_multiply::IS_CALL;

use super::format::{Length, NEAR_LIMIT};
use super::product::wide;

/// Returns true if the quotient `2^30 n / d`, in units of 2^-28, is at least `limit`. `d` must be
/// below 2^31.
///
/// The function multiplies and does not divide. On Armv6-M, where each product is a function call,
/// the comparison with [`NEAR_LIMIT`] uses shifts instead. The comparison by shifts may return
/// false for quotients from `NEAR_LIMIT` to less than `NEAR_LIMIT + 2^-28`. All other results are
/// exact.
pub(crate) fn quotient_reaches(n: u32, d: u32, limit: Length) -> bool {
    if IS_CALL && limit == NEAR_LIMIT {
        reaches_near_limit(n, d)
    } else {
        reaches(n, d, limit)
    }
}

/// Returns true if `2^30 n / d` is at least the raw bits of `limit`. The result is exact, because
/// the function compares `2^30 n` with the product of `d` and the limit.
fn reaches(n: u32, d: u32, limit: Length) -> bool {
    u64::from(n) << 30 >= wide(d, limit.to_bits() as u32)
}

/// Returns true if `2^30 n / d` is at least 2^31 - 1024, which is the raw bits of [`NEAR_LIMIT`]
/// plus 1. The function uses shifts instead of a product.
fn reaches_near_limit(n: u32, d: u32) -> bool {
    n >= 2 * d - (d >> 20)
}

#[cfg(test)]
mod tests {
    use fastrand::Rng;

    use super::*;

    /// Asserts that the comparison by shifts agrees with the exact comparison. The results may
    /// differ only for quotients from [`NEAR_LIMIT`] to less than `NEAR_LIMIT + 2^-28`.
    fn check(n: u32, d: u32) {
        let (exact, by_shifts) = (reaches(n, d, NEAR_LIMIT), reaches_near_limit(n, d));
        if exact != by_shifts {
            let above = Length::from_bits(NEAR_LIMIT.to_bits() + 1);
            assert!(exact && !reaches(n, d, above), "{n} / {d}");
        }
    }

    #[test]
    fn both_forms_agree_outside_one_step_above_the_limit() {
        let mut random = Rng::with_seed(1);
        for _ in 0..if cfg!(miri) { 200 } else { 1_000_000 } {
            let d = random.u32(1..1 << 31) >> random.u32(..31);
            check(random.u32(..1 << 31) >> random.u32(..31), d);
            // Checks numerators at which the quotient is close to the limit, because the results
            // of the two comparisons may differ there.
            let threshold = 2 * u64::from(d) - ((u64::from(d) * 1025) >> 30);
            for n in threshold.saturating_sub(4)..=threshold + 4 {
                if let Ok(n) = u32::try_from(n) {
                    check(n, d);
                }
            }
        }
        for d in [
            1,
            2,
            (1 << 20) - 1,
            1 << 20,
            (1 << 30) - 1,
            1 << 30,
            (1 << 31) - 1,
        ] {
            for n in [0, 1, 2 * d - 1, 2 * d - (d >> 20), 2 * d, u32::MAX] {
                check(n, d);
            }
        }
    }

    #[test]
    fn the_form_of_this_core_agrees_with_the_exact_quotient() {
        for (n, d, reached) in [(1, 1, false), (2, 1, true), (7, 4, false), (8, 4, true)] {
            assert_eq!(quotient_reaches(n, d, NEAR_LIMIT), reached, "{n} / {d}");
        }
        assert!(quotient_reaches(1, 1, Length::from_num(4)));
        assert!(!quotient_reaches(1, 1, Length::from_bits((1 << 30) + 1)));
    }
}
