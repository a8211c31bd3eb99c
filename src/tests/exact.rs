//! Arithmetic of formats against exact integers: a million random operands for
//! each operation, at the ends of their ranges as often as within.
//!
//! The tests are built with `overflow-checks`, so they also show that nothing
//! overflows on the ranges that docs/fixed-point.md names.

#![cfg(test)]

extern crate std;

use std::println;

use crate::math::{
    Color, Factor, Intensity, Length, Product, Radiance, Real, Square, Unit, Vec3, Weight, color,
    round_length, round_unit, wide,
};
use crate::observer;

/// Miri takes a thousand times as long for each.
const CASES: u32 = if cfg!(miri) { 200 } else { 1_000_000 };

/// Steele, Lea and Flood 2014: SplitMix64.
struct Random(u64);

impl Random {
    fn word(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Either end of a range, or any magnitude within.
    fn within(&mut self, least: i64, most: i64) -> i64 {
        let word = self.word();
        let number = match word & 7 {
            0 => least,
            1 => most,
            _ => self.word() as i64 >> (word >> 3 & 63),
        };
        number.clamp(least, most)
    }

    fn word32(&mut self) -> i32 {
        self.within(i32::MIN.into(), i32::MAX.into()) as i32
    }

    /// Up to 1 in each component.
    fn unit(&mut self) -> Vec3<Unit> {
        let mut c = || Unit::from_bits(self.within(-1 << 30, 1 << 30) as i32);
        Vec3::new(c(), c(), c())
    }

    /// Less than 8 long.
    fn length(&mut self) -> Vec3<Length> {
        // 8 / sqrt(3)
        const MOST: i64 = 1_239_850_262;
        let mut c = || Length::from_bits(self.within(-MOST, MOST) as i32);
        Vec3::new(c(), c(), c())
    }

    fn factors(&mut self) -> Color<Factor> {
        let mut c = || Factor::from_bits(self.within(0, 1 << 15) as u16);
        Color::new(c(), c(), c())
    }

    fn radiance(&mut self) -> Color<Radiance> {
        let mut c = || Radiance::from_bits(self.within(0, u32::MAX.into()) as u32);
        Color::new(c(), c(), c())
    }
}

fn each(what: &str, holds: impl Fn(&mut Random) -> bool) {
    let mut random = Random(1);
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

/// `n / 2^shift`, rounded half up.
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
        let (a, b) = (random.word32(), random.word32());
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
        let bits = random.within(-1 << 60, 1 << 60);
        let exact = rounded(bits.into(), 30);
        i128::from(round_unit::<30>(bits).to_bits()) == exact
            && i128::from(round_length::<30>(bits).to_bits()) == exact
    });
}

#[test]
fn products_of_vectors() {
    each("products of vectors", |random| {
        let (l, d, e) = (random.length(), random.unit(), random.unit());
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
        // A direction is at most 1 long; so is its cosine with another.
        let shorter = |v: Vec3<Unit>| v.map(|c| Unit::from_bits(c.to_bits() / 7 * 4));
        let (l, d, e) = (
            random.length(),
            shorter(random.unit()),
            shorter(random.unit()),
        );
        let distance = l.x;
        let turned = cross(lengths(l), units(d)).map(|c| rounded(c, 30));
        let times = units(d).map(|c| rounded(c * i128::from(distance.to_bits()), 30));
        lengths(Vec3::<Length>::cross(l, d)) == turned
            && lengths(d.times(distance)) == times
            && i128::from(d.cosine(e).to_bits()) == rounded(dot(units(d), units(e)), 30)
    });
}

/// Each channel's bits.
fn channels<T: Into<i128>>(color: Color<T>) -> [i128; 3] {
    [color.r.into(), color.g.into(), color.b.into()]
}

#[test]
fn products_of_factors() {
    each("products of factors", |random| {
        let (a, b) = (random.factors(), random.factors());
        let intensity = Intensity::from_bits(random.within(0, 1 << 16) as u32);
        let bits = |c: Color<Factor>| channels(c.map(Factor::to_bits));
        let filtered = [0, 1, 2].map(|i| rounded(bits(a)[i] * bits(b)[i], 15));
        let reflected = [0, 1, 2].map(|i| {
            let most = bits(a)[i] * bits(b)[i];
            (most * i128::from(intensity.to_bits())) >> 17 << 1
        });
        let shown = a.reflect(intensity, b).map(Radiance::to_bits);
        bits(a.filtered(b)) == filtered
            && channels(shown) == reflected
            && color::product(a.r, b.r) <= a.r.min(b.r)
    });
}

#[test]
fn radiances() {
    each("radiances", |random| {
        let (a, b) = (random.radiance(), random.radiance());
        let exponent = random.within(0, 15) as u32;
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
fn weights() {
    each("weights", |random| {
        let radiance = random.radiance();
        let mut weight = || random.radiance().map(|c| Weight::from_bits(c.to_bits()));
        let (weight, share) = (weight(), weight());
        let bits = |c: Color<Weight>| channels(c.map(Weight::to_bits));
        let weighed = channels(weight.weigh(radiance).map(Radiance::to_bits));
        let shared = bits(weight.shared(share));
        (0..3).all(|i| {
            let radiance = channels(radiance.map(Radiance::to_bits))[i];
            let (weight, share) = (bits(weight)[i], bits(share)[i]);
            weighed[i] == (weight * radiance) >> 32 && shared[i] == (weight * share) >> 32
        })
    });
    let all = Color::<Weight>::ALL;
    assert_eq!(observer::weight(all), Color::gray(Real::ONE));
    let half = all.map(|c| c / 2);
    assert_eq!(all.shared(all).narrowed(), Color::WHITE);
    assert_eq!(
        observer::weight(all.shared(half)),
        Color::gray(Real::ONE / 2)
    );
}
