//! Dithering: the mean of every 8x8 box of pixels matches the mean of the undithered
//! values.

use embedded_graphics::pixelcolor::{BinaryColor, Gray2, Gray4, Rgb565};
use embedded_graphics::prelude::*;
use whitted::render::{DisplayColor, Output, Transfer};
use whitted::{Color, Radiance};

/// Gray ramp from black, at the left or top edge or the top left corner, to white.
#[derive(Clone, Copy, Debug)]
struct Ramp {
    /// Number of columns from black to white; infinite for a vertical ramp.
    columns: f64,
    /// Number of rows from black to white; infinite for a horizontal ramp.
    rows: f64,
    /// True for a ramp from white to black.
    falls: bool,
}

impl Ramp {
    /// Returns the gray value of a pixel, 0 to 1.
    fn at(&self, x: i32, y: i32) -> f64 {
        let value = (f64::from(x) / self.columns + f64::from(y) / self.rows).min(1.0);
        if self.falls { 1.0 - value } else { value }
    }
}

/// Channels of a display color as fractions of full scale.
trait Channels: DisplayColor {
    fn channels(self) -> Vec<f64>;
}

impl Channels for Rgb565 {
    fn channels(self) -> Vec<f64> {
        vec![
            f64::from(self.r()) / 31.0,
            f64::from(self.g()) / 63.0,
            f64::from(self.b()) / 31.0,
        ]
    }
}

impl Channels for Gray4 {
    fn channels(self) -> Vec<f64> {
        vec![f64::from(self.luma()) / 15.0]
    }
}

impl Channels for Gray2 {
    fn channels(self) -> Vec<f64> {
        vec![f64::from(self.luma()) / 3.0]
    }
}

impl Channels for BinaryColor {
    fn channels(self) -> Vec<f64> {
        vec![f64::from(u8::from(self.is_on()))]
    }
}

const SIZE: Size = Size::new(672, 120);

/// Returns the linear radiance that a transfer function maps to this gray value.
fn light(value: f64, transfer: Transfer) -> Color<Radiance> {
    let light = match transfer {
        Transfer::Linear => value,
        // Inverse of the sRGB transfer function, IEC 61966-2-1.
        Transfer::Srgb if value <= 0.040_45 => value / 12.92,
        Transfer::Srgb => ((value + 0.055) / 1.055).powf(2.4),
    };
    let light = Radiance::saturating_from_num(light);
    Color::new(light, light, light)
}

/// Returns the largest error of the mean of an 8x8 box, in units of 1/255. Boxes
/// start at every `step`-th row and column.
fn largest_box_error<P: Channels>(ramp: Ramp, transfer: Transfer, step: usize) -> f64 {
    let output = Output {
        transfer,
        ..Output::default()
    };
    let error = |x, y| {
        let value = ramp.at(x, y);
        let pixel = P::from_radiance(light(value, transfer), Point::new(x, y), output);
        pixel.channels().into_iter().map(move |shown| shown - value)
    };
    let rows = 0..SIZE.height as i32;
    let errors: Vec<Vec<Vec<f64>>> = rows
        .map(|y| {
            (0..SIZE.width as i32)
                .map(|x| error(x, y).collect())
                .collect()
        })
        .collect();
    let mut worst = 0.0_f64;
    for top in (0..=errors.len() - 8).step_by(step) {
        for left in (0..=SIZE.width as usize - 8).step_by(step) {
            for channel in 0..errors[0][0].len() {
                let rows = errors[top..top + 8].iter();
                let sum: f64 = rows
                    .flat_map(|row| &row[left..left + 8])
                    .map(|pixel| pixel[channel])
                    .sum();
                worst = worst.max((sum / 64.0).abs() * 255.0);
            }
        }
    }
    worst
}

/// Checks the limits of four color types: 1/255 for 16-bit color, 4/255 for 4, 2
/// and 1 bits of gray.
#[track_caller]
fn check(ramp: Ramp, step: usize) {
    for transfer in [Transfer::Linear, Transfer::Srgb] {
        let errors = [
            (
                "Rgb565",
                largest_box_error::<Rgb565>(ramp, transfer, step),
                1.0,
            ),
            (
                "Gray4",
                largest_box_error::<Gray4>(ramp, transfer, step),
                4.0,
            ),
            (
                "Gray2",
                largest_box_error::<Gray2>(ramp, transfer, step),
                4.0,
            ),
            (
                "BinaryColor",
                largest_box_error::<BinaryColor>(ramp, transfer, step),
                4.0,
            ),
        ];
        println!("{ramp:?}, {transfer:?}: {errors:.2?}");
        for (color, error, bound) in errors {
            assert!(error <= bound, "{color}, {ramp:?}, {transfer:?}: {error}");
        }
    }
}

/// Ramps of 448 pixels and more change by at most 1/56 within a box. On steeper
/// ramps the error of the mean can exceed 4/255.
#[test]
fn every_box_of_smooth_ramps_keeps_mean() {
    for length in [448.0, 500.0, 640.0, 1024.0, 4096.0] {
        for falls in [false, true] {
            for (columns, rows) in [
                (length, f64::INFINITY),
                (f64::INFINITY, length),
                (2.0 * length, 2.0 * length),
                (1.5 * length, 3.0 * length),
            ] {
                let ramp = Ramp {
                    columns,
                    rows,
                    falls,
                };
                check(ramp, 1);
            }
        }
    }
}

#[test]
fn aligned_boxes_of_display_wide_ramps_keep_mean() {
    for columns in [240.0, 255.0, 256.0, 319.0, 320.0] {
        let ramp = Ramp {
            columns,
            rows: f64::INFINITY,
            falls: false,
        };
        check(ramp, 8);
    }
}
