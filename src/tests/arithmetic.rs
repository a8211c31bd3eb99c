//! Error bounds of reciprocals, roots, powers and quotients, against double precision.

extern crate std;

use std::println;

use crate::math::{
    SoftFloat, inverse_length, power, quotient, reciprocal, reciprocal_root, square_root,
    upper_product,
};
use crate::tests::random::words;

/// Prints the largest of some errors, each a share of its bound, and asserts that it is below 1.
fn check(what: &str, shares: impl Iterator<Item = f64>) {
    let largest = shares.map(f64::abs).fold(0.0, f64::max);
    println!("{what}: {largest:.2} of the bound");
    assert!(largest < 1.0, "{what}: {largest}");
}

#[test]
fn reciprocals_are_within_their_bound() {
    let share = |word| {
        let x = word | 1 << 31;
        let exact = 2_f64.powi(63) / f64::from(x);
        (f64::from(reciprocal(x)) - exact) / exact * 2_f64.powi(30)
    };
    check("reciprocal", words().map(share));
}

#[test]
fn reciprocal_roots_are_within_their_bound() {
    let share = |x| {
        let exact = 2_f64.powi(31) / (f64::from(x) / 2_f64.powi(32)).sqrt();
        (f64::from(reciprocal_root(x)) - exact) / exact * 2_f64.powi(30)
    };
    let both = words().flat_map(|word| [word | 1 << 31, word >> 1 | 1 << 30]);
    check("reciprocal root", both.map(share));
}

#[test]
fn square_roots_are_within_their_bound() {
    let pairs = words().zip(words().skip(1));
    let numbers = pairs.flat_map(|(high, low)| {
        let x = u64::from(high) << 32 | u64::from(low);
        [x, x >> 17, x >> 32, x >> 60]
    });
    let share = |x| {
        let exact = (x as f64).sqrt();
        let error = f64::from(square_root(x)) - exact;
        error / (0.5 + exact * 2_f64.powi(-29))
    };
    check("square root", numbers.map(share));
}

#[test]
fn cosines_are_within_their_bound() {
    let cases = words().zip(words().skip(9)).zip(words().skip(5));
    let cosines = cases.map(|((high, low), part)| {
        // The square of a length below 8, and a random component of the vector.
        let square = (u64::from(high) << 32 | u64::from(low)) >> (2 + (part & 31));
        let length = (square as f64).sqrt();
        let share = f64::from(part as i32) / 2_f64.powi(31);
        let along = (share * length * 2_f64.powi(30)) as i64;
        let exact = along as f64 / length.max(1.0);
        let cosine = inverse_length(square).cosine(along);
        (f64::from(cosine.to_bits()) - exact) / 4.0
    });
    check("cosine", cosines);
}

#[test]
fn powers_are_within_their_bound() {
    let cases = words().zip(words().skip(7)).take(100_000);
    let cases = cases.flat_map(|(base, exponent)| {
        let exponent = exponent | 1 << 31;
        [exponent >> 4, exponent >> 9, exponent >> 15, 1 << 28]
            .map(|exponent| (base >> 1, exponent))
    });
    let share = |(base, exponent)| {
        let s = f64::from(exponent) / 65536.0;
        let exact = (f64::from(base) / 2_f64.powi(31)).powf(s);
        let error = f64::from(power(base, exponent)) / 2_f64.powi(31) - exact;
        error / (2_f64.powi(-30) * (s + 16.0))
    };
    check("power", cases.map(share));
}

#[test]
fn quotients_and_upper_products_are_within_their_bound() {
    let numbers = || {
        let pairs = words().zip(words().skip(3));
        pairs.map(|(high, low)| (u64::from(high) << 32 | u64::from(low)) >> (low & 31) | 1)
    };
    let pairs = || numbers().zip(numbers().skip(5));
    let value = |x: SoftFloat| f64::from(x.mantissa) * 2_f64.powi(x.exponent);
    let quotients = pairs().map(|(n, d)| {
        let exact = n as f64 / d as f64 * 2_f64.powi(30);
        (value(quotient(n, d)) - exact) / exact * 2_f64.powi(29)
    });
    check("quotient", quotients);
    let products = pairs().map(|(a, b)| {
        let exact = a as f64 * b as f64 * 2_f64.powi(-64);
        let error = upper_product(a, b, 0) as f64 - exact;
        error / (1.0 + exact * 2_f64.powi(-30))
    });
    check("upper product", products);
}
