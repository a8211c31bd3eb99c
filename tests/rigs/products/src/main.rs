//! Compares every operation of `long-multiply` with plain arithmetic, for all pairs of
//! edge values and two million random pairs.

#![no_std]
#![no_main]

use core::hint::black_box;
use core::panic::PanicInfo;

use cortex_m_rt::entry;

/// Number of random pairs.
const RANDOM_PAIRS: u32 = 2_000_000;

#[entry]
fn main() -> ! {
    match compare() {
        Ok(pairs) => mps2::print(format_args!("pairs: {pairs}\n")),
        Err((a, b)) => mps2::print(format_args!("error: wrong product of {a:#x} and {b:#x}\n")),
    }
    mps2::exit();
}

/// Compares the operations for all pairs and returns the number of pairs.
///
/// # Errors
/// Returns the first pair for which an operation has a wrong result.
fn compare() -> Result<u32, (u32, u32)> {
    let mut pairs = 0;
    for a in edge_values() {
        for b in edge_values() {
            pairs += 1;
            check_pair(a, b)?;
        }
    }
    // The random pairs are from the generator xorshift64 (Marsaglia, 2003).
    let mut state = 1_u64;
    for _ in 0..RANDOM_PAIRS {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        pairs += 1;
        check_pair((state >> 32) as u32, state as u32)?;
    }
    Ok(pairs)
}

/// Returns each power of two, its neighbors, its complement and its negative.
fn edge_values() -> impl Iterator<Item = u32> {
    (0..32).flat_map(|bit| {
        let x = 1_u32 << bit;
        [x, x - 1, x + 1, !x, x.wrapping_neg()]
    })
}

/// Checks all operations for one pair.
fn check_pair(a: u32, b: u32) -> Result<(), (u32, u32)> {
    let (i, j) = (a as i32, b as i32);
    // `black_box` keeps the compiler from evaluating the expected products early.
    let (p, q) = (black_box(i64::from(i)), black_box(u64::from(a)));
    let c = a >> 11;
    let d = black_box(u64::from(c));
    let v = [i, j, i.wrapping_sub(j)];
    let scaled = |shift: u32, by: i32| {
        let half = black_box(1_i64 << (shift - 1));
        v.map(|c| ((i64::from(c) * i64::from(by) + half) >> shift) as i32)
    };
    let scaled_one = |shift: u32| {
        let half = black_box(1_i64 << (shift - 1));
        ((p * i64::from(j) + half) >> shift) as i32
    };
    let product = p * i64::from(j);
    let rounded =
        |shift: u32| ((product.wrapping_add(black_box(1_i64 << (shift - 1)))) >> shift) as i32;
    let half_j = black_box(i64::from(j));
    let upper = b | 1 << 31;
    let half = black_box(1_i64 << 31);
    let reduced = v.map(|c| ((i64::from(c) * i64::from(upper) + half) >> 32) as i32);
    let is_correct = long_multiply::signed(i, j) == p * i64::from(j)
        && long_multiply::unsigned(a, b) == q * u64::from(b)
        && long_multiply::mixed(i, b) == p * i64::from(b)
        && long_multiply::square(i) == p * i64::from(i)
        && long_multiply::middle(a, b) == ((q * u64::from(b)) >> 16) as u32
        && long_multiply::square_of_21_bits(c) == ((d * u64::from(c)) >> 10) as u32
        && long_multiply::scaled::<29>(v, j) == scaled(29, j)
        && long_multiply::scaled::<30>(v, j) == scaled(30, j)
        && long_multiply::scaled::<30>(v, i) == scaled(30, i)
        && long_multiply::by_16_bits(a & 0xffff, j)
            == ((i64::from(a as u16) * half_j) >> 31) as i32
        && long_multiply::by_17_bits((a >> 16) + 1, b)
            == ((((q >> 16) + 1) * u64::from(b)) >> 17) as u32
        && long_multiply::upper(i, j) == scaled_one(31)
        && long_multiply::reduced(v, upper) == reduced
        && long_multiply::rounded::<1>(product) == rounded(1)
        && long_multiply::rounded::<28>(product) == rounded(28)
        && long_multiply::rounded::<29>(product) == rounded(29)
        && long_multiply::rounded::<30>(product) == rounded(30)
        && long_multiply::rounded::<31>(product) == rounded(31)
        && long_multiply::leading_zeros(a) == black_box(a).leading_zeros();
    is_correct.then_some(()).ok_or((a, b))
}

#[panic_handler]
fn panic(info: &PanicInfo<'_>) -> ! {
    mps2::print(format_args!("error: {info}\n"));
    mps2::exit();
}
