//! Operations that are exact, or round an exact result, against 128-bit integers.
//!
//! Each operation gets a million random operands, many of them at the ends of their ranges.
//! Tests are built with `overflow-checks`, so the operations do not overflow either on the
//! ranges that docs/fixed-point.md lists.

extern crate std;

use std::println;

use fastrand::Rng;

use crate::math::{
    Color, Factor, Intensity, Length, Product, Radiance, Real, Square, Unit, Vec3, Weight,
    round_length, round_unit, wide,
};
use crate::observer;
use crate::tests::random::within;

/// Miri takes a thousand times as long for each.
const CASES: u32 = if cfg!(miri) { 200 } else { 1_000_000 };

fn word32(random: &mut Rng) -> i32 {
    within(random, i32::MIN.into(), i32::MAX.into()) as i32
}

/// Returns a vector with components between -1 and 1.
fn unit(random: &mut Rng) -> Vec3<Unit> {
    let mut c = || Unit::from_bits(within(random, -1 << 30, 1 << 30) as i32);
    Vec3::new(c(), c(), c())
}

/// Returns a vector shorter than 8.
fn length(random: &mut Rng) -> Vec3<Length> {
    // 8 / sqrt(3)
    const MOST: i64 = 1_239_850_262;
    let mut c = || Length::from_bits(within(random, -MOST, MOST) as i32);
    Vec3::new(c(), c(), c())
}

fn factors(random: &mut Rng) -> Color<Factor> {
    let mut c = || Factor::from_bits(within(random, 0, 1 << 15) as u16);
    Color::new(c(), c(), c())
}

fn radiance(random: &mut Rng) -> Color<Radiance> {
    let mut c = || Radiance::from_bits(within(random, 0, u32::MAX.into()) as u32);
    Color::new(c(), c(), c())
}

fn weights(random: &mut Rng) -> Color<Weight> {
    radiance(random).map(|c| Weight::from_bits(c.to_bits()))
}

/// Asserts that `holds` returns true for each of a million random operands.
fn each(what: &str, holds: impl Fn(&mut Rng) -> bool) {
    let mut random = Rng::with_seed(1);
    for case in 0..CASES {
        assert!(holds(&mut random), "{what}, case {case}");
    }
    println!("figure: {CASES} {what} exact");
}

fn integers(v: Vec3<impl Into<i128>>) -> [i128; 3] {
    [v.x.into(), v.y.into(), v.z.into()]
}

fn lengths(v: Vec3<Length>) -> [i128; 3] {
    integers(v.map(Length::to_bits))
}

fn units(v: Vec3<Unit>) -> [i128; 3] {
    integers(v.map(Unit::to_bits))
}

fn dot(a: [i128; 3], b: [i128; 3]) -> i128 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Returns `n / 2^shift`, rounded half up.
fn rounded(n: i128, shift: u32) -> i128 {
    (2 * n + (1 << shift)).div_euclid(2 << shift)
}

fn cross(a: [i128; 3], b: [i128; 3]) -> [i128; 3] {
    [0, 1, 2].map(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        a[j] * b[k] - a[k] * b[j]
    })
}

#[test]
fn full_products() {
    each("products", |random| {
        let (a, b) = (word32(random), word32(random));
        let (i, j) = (i128::from(a), i128::from(b));
        let (u, v) = (i128::from(a as u32), i128::from(b as u32));
        i128::from(a.product(b)) == i * j
            && i128::from(a.product(b as u32)) == i * v
            && i128::from(wide(a as u32, b as u32)) == u * v
            && i128::from(a.square()) == i * i
    });
}

#[test]
fn roundings() {
    each("roundings", |random| {
        let bits = within(random, -1 << 60, 1 << 60);
        let exact = rounded(bits.into(), 30);
        i128::from(round_unit::<30>(bits).to_bits()) == exact
            && i128::from(round_length::<30>(bits).to_bits()) == exact
    });
}

#[test]
fn products_of_vectors() {
    each("products of vectors", |random| {
        let (l, d, e) = (length(random), unit(random), unit(random));
        let exact = cross(units(d), units(e));
        i128::from(l.along(d).to_bits()) == dot(lengths(l), units(d))
            && i128::from(l.squared().to_bits()) == dot(lengths(l), lengths(l))
            && i128::from(d.dot(e).to_bits()) == dot(units(d), units(e))
            && integers(Vec3::<Unit>::cross(d, e)) == exact
    });
}

#[test]
fn rounded_products_of_vectors() {
    each("rounded products of vectors", |random| {
        // At most 1 long, as directions are: 4/7 is below 1/sqrt(3).
        let shorter = |v: Vec3<Unit>| v.map(|c| Unit::from_bits(c.to_bits() / 7 * 4));
        let (l, d, e) = (length(random), shorter(unit(random)), shorter(unit(random)));
        let distance = l.x;
        let turned = cross(lengths(l), units(d)).map(|c| rounded(c, 30));
        let times = units(d).map(|c| rounded(c * i128::from(distance.to_bits()), 30));
        lengths(Vec3::<Length>::cross(l, d)) == turned
            && lengths(d.times(distance)) == times
            && i128::from(d.cosine(e).to_bits()) == rounded(dot(units(d), units(e)), 30)
    });
}

/// Returns the three channels as integers.
fn channels<T: Into<i128>>(color: Color<T>) -> [i128; 3] {
    [color.r.into(), color.g.into(), color.b.into()]
}

#[test]
fn products_of_factors() {
    each("products of factors", |random| {
        let (a, b) = (factors(random), factors(random));
        let intensity = Intensity::from_bits(within(random, 0, 1 << 16) as u32);
        let bits = |c: Color<Factor>| channels(c.map(Factor::to_bits));
        let filtered = [0, 1, 2].map(|i| rounded(bits(a)[i] * bits(b)[i], 15));
        let reflected = [0, 1, 2].map(|i| {
            let most = bits(a)[i] * bits(b)[i];
            (most * i128::from(intensity.to_bits())) >> 17 << 1
        });
        let shown = a.reflect(intensity, b).map(Radiance::to_bits);
        bits(a.filtered(b)) == filtered
            && channels(shown) == reflected
            && a.filtered(b).r <= a.r.min(b.r)
    });
}

#[test]
fn sums_and_brightening_of_radiances() {
    each("radiances", |random| {
        let (a, b) = (radiance(random), radiance(random));
        let exponent = within(random, 0, 15) as u32;
        let bits = |c: Color<Radiance>| channels(c.map(Radiance::to_bits));
        let most = i128::from(u32::MAX);
        let (plus, brightened) = (bits(a.plus(b)), bits(a.brightened(exponent)));
        (0..3).all(|i| {
            let (a, b) = (bits(a)[i], bits(b)[i]);
            plus[i] == (a + b).min(most) && brightened[i] == (a << exponent).min(most)
        })
    });
}

#[test]
fn products_of_weights() {
    each("weights", |random| {
        let light = radiance(random);
        let (weight, share) = (weights(random), weights(random));
        let bits = |c: Color<Weight>| channels(c.map(Weight::to_bits));
        let weighed = channels(weight.weigh(light).map(Radiance::to_bits));
        let shared = bits(weight.shared(share));
        (0..3).all(|i| {
            let light = channels(light.map(Radiance::to_bits))[i];
            let (weight, share) = (bits(weight)[i], bits(share)[i]);
            weighed[i] == (weight * light) >> 32 && shared[i] == (weight * share) >> 32
        })
    });
    let all = Color::<Weight>::ALL;
    assert_eq!(observer::weight_to_real(all), Color::gray(Real::ONE));
    let half = all.map(|c| c / 2);
    assert_eq!(all.shared(all).narrowed(), Color::WHITE);
    assert_eq!(
        observer::weight_to_real(all.shared(half)),
        Color::gray(Real::ONE / 2)
    );
}
