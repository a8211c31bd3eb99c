//! What dithering promises: a box of 8x8 pixels has the mean of what it shows.

use embedded_graphics::pixelcolor::{BinaryColor, Gray2, Gray4, Rgb565};
use embedded_graphics::prelude::*;
use whitted::render::{DisplayColor, Output, Transfer};
use whitted::{Color, Radiance};

/// A picture that rises evenly from black at a corner or an edge to white.
#[derive(Clone, Copy, Debug)]
struct Ramp {
    /// 1 / slope: columns from black to white.
    columns: f64,
    /// The same for rows.
    rows: f64,
    /// Whether it falls, from white to black.
    falls: bool,
}

const RISING: Ramp = Ramp {
    columns: f64::INFINITY,
    rows: f64::INFINITY,
    falls: false,
};

impl Ramp {
    fn at(&self, x: i32, y: i32) -> f64 {
        let value = (f64::from(x) / self.columns + f64::from(y) / self.rows).min(1.0);
        if self.falls { 1.0 - value } else { value }
    }
}

/// A color's channels as shares of full scale.
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

/// The gray light that is shown as a value.
fn light(value: f64, transfer: Transfer) -> Color<Radiance> {
    let light = match transfer {
        Transfer::Linear => value,
        // IEC 61966-2-1, backwards.
        Transfer::Srgb if value <= 0.040_45 => value / 12.92,
        Transfer::Srgb => ((value + 0.055) / 1.055).powf(2.4),
    };
    let light = Radiance::saturating_from_num(light);
    Color::new(light, light, light)
}

/// The largest error of the mean of an 8x8 box, in 1/255; of boxes that start
/// at each `step`th row and column.
fn worst<P: Channels>(ramp: Ramp, transfer: Transfer, step: usize) -> f64 {
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

#[track_caller]
fn holds(ramp: Ramp, step: usize) {
    for transfer in [Transfer::Linear, Transfer::Srgb] {
        let errors = [
            ("Rgb565", worst::<Rgb565>(ramp, transfer, step), 1.0),
            ("Gray4", worst::<Gray4>(ramp, transfer, step), 4.0),
            ("Gray2", worst::<Gray2>(ramp, transfer, step), 4.0),
            (
                "BinaryColor",
                worst::<BinaryColor>(ramp, transfer, step),
                4.0,
            ),
        ];
        println!("{ramp:?}, {transfer:?}: {errors:.2?}");
        for (color, error, bound) in errors {
            assert!(error <= bound, "{color}, {ramp:?}, {transfer:?}: {error}");
        }
    }
}

/// A ramp of 448 pixels changes by a box's 1/64 in half of the box; steeper
/// ones have more pixels of one column between two levels than make up 4/255.
#[test]
fn any_box_of_a_smooth_ramp_has_its_mean() {
    for length in [448.0, 500.0, 640.0, 1024.0, 4096.0] {
        for falls in [false, true] {
            let across = Ramp {
                columns: length,
                falls,
                ..RISING
            };
            holds(across, 1);
            let down = Ramp {
                rows: length,
                falls,
                ..RISING
            };
            holds(down, 1);
            let diagonal = Ramp {
                columns: 2.0 * length,
                rows: 2.0 * length,
                falls,
            };
            holds(diagonal, 1);
            let slanted = Ramp {
                columns: 1.5 * length,
                rows: 3.0 * length,
                falls,
            };
            holds(slanted, 1);
        }
    }
}

#[test]
fn tiles_of_a_ramp_over_a_small_display_have_its_mean() {
    for columns in [240.0, 255.0, 256.0, 319.0, 320.0] {
        holds(Ramp { columns, ..RISING }, 8);
    }
}
