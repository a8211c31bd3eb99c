//! Double-precision vectors, and the largest error of an operation.

extern crate std;

use std::println;

use crate::math::{Length, Unit, Vec3};

pub(crate) type Floats = Vec3<f64>;

pub(crate) fn lengths(v: Vec3<Length>) -> Floats {
    v.map(Length::to_num)
}

pub(crate) fn units(v: Vec3<Unit>) -> Floats {
    v.map(Unit::to_num)
}

pub(crate) fn dot(a: Floats, b: Floats) -> f64 {
    a.x * b.x + a.y * b.y + a.z * b.z
}

pub(crate) fn times(a: Floats, k: f64) -> Floats {
    a.map(|c| c * k)
}

/// Scales a vector to unit length.
pub(crate) fn unit(a: Floats) -> Floats {
    times(a, 1.0 / length(a))
}

pub(crate) fn length(a: Floats) -> f64 {
    dot(a, a).sqrt()
}

/// The largest error of a stage, in units of 2^exponent.
pub(crate) struct LargestError {
    stage: &'static str,
    exponent: i32,
    bound: f64,
    largest: f64,
    count: u32,
}

impl LargestError {
    pub(crate) fn new(stage: &'static str, exponent: i32, bound: f64) -> Self {
        Self {
            stage,
            exponent,
            bound,
            largest: 0.0,
            count: 0,
        }
    }

    pub(crate) fn add(&mut self, error: f64) {
        self.largest = self.largest.max(error.abs() * 2_f64.powi(-self.exponent));
        self.count += 1;
    }

    /// Prints the largest error. Fails if it exceeds the bound, or after 10,000 cases or fewer.
    pub(crate) fn check(self) {
        let Self {
            stage,
            exponent,
            bound,
            largest,
            count,
        } = self;
        println!("{stage}: {largest:.2} of {bound} * 2^{exponent}, {count} cases");
        assert!(count > 10_000, "{stage}: only {count} cases");
        assert!(largest <= bound, "{stage}: {largest} exceeds {bound}");
    }
}
