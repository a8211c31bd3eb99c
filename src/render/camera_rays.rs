//! Where rays come from: a pinhole camera in front of a raster of pixels.

use crate::geometry::{Plane, Point};
use crate::math::outlined::{inverse_length, reciprocal, to_bits};
use crate::math::{
    Length, Product, SoftFloat, Square, Unit, Vec3, high, quotient, square_root, wide,
};
use crate::prepare::Camera;

/// A vector times `factor / 2^shift`, rounded down.
///
/// As other small functions here it is not inlined: views are rare, and lines are long.
#[inline(never)]
fn scaled(v: &Vec3<Unit>, factor: u32, shift: u32) -> Vec3<i64> {
    v.map(|c| c.to_bits().product(factor) >> shift)
}

/// The square of `side / 2^shift`, or a little more.
#[inline(never)]
fn square_above(side: u64, shift: u32) -> u64 {
    ((side >> shift) + 1).pow(2)
}

/// So many steps from a direction; what overflows wraps around.
#[inline(never)]
fn stepped(direction: Vec3<i64>, step: &Vec3<i64>, count: i32) -> Vec3<i64> {
    direction.zip(*step, |d, s| d.wrapping_add(s.wrapping_mul(count.into())))
}

/// The widest and the highest raster.
pub(crate) const MAX_SIDE: u32 = u16::MAX as u32;

/// A camera's view of a raster of pixels.
///
/// The direction through the center of pixel (x, y) is `f + X r + Y u` with
/// `X = (2x + 1 - width) g`, `Y = (height - 2y - 1) g` and
/// `g = tan(fovy / 2) / height`. Directions are in steps of 2^-62, scaled so that the
/// longest are 7/8: 8 of them lead from -3.5 to 3.5, between which points are near. Along a
/// line they are added up.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CameraRays {
    eye: Vec3<Length>,
    /// `f + X r` of the first column.
    left: Vec3<i64>,
    /// `g r`: half a pixel to the right.
    right: Vec3<i64>,
    /// `g u`: half a pixel up.
    up: Vec3<i64>,
    /// g as `U6F58`.
    half_pixel: u64,
    pub(crate) width: u32,
    pub(crate) height: u32,
}

impl CameraRays {
    #[inline(never)]
    pub(crate) fn new(camera: &Camera, width: u32, height: u32) -> Self {
        let (width, height) = (width.min(MAX_SIDE), height.min(MAX_SIDE));
        // tangent / height: U4F28 * U1F31 -> U6F58
        let shift = height.max(1).leading_zeros();
        let g = wide(camera.tangent, reciprocal(height.max(1) << shift)) >> (33 - shift);
        // sqrt(1 + X² + Y²), Q28, is the length of the longest direction; squared in Q56 or, if
        // it is long, coarser.
        let sides = [width, height].map(|side| ((g >> 30) + 1) * u64::from(side));
        let coarser = (64 - (sides[0] | sides[1]).leading_zeros()).saturating_sub(30);
        let square = |side| square_above(side, coarser);
        let longest_squared = square(1 << 28) + square(sides[0]) + square(sides[1]);
        let longest = u64::from(square_root(longest_squared)) << coarser;
        // What makes it 7/8: U1F31, below 1.
        let scale = to_bits(quotient(7 << 26, longest)) as u32;
        let scaled_g = (wide((g >> 32) as u32, scale) << 1) + (wide(g as u32, scale) >> 31);
        let g_shift = scaled_g.max(1).leading_zeros();
        let g_mantissa = ((scaled_g << g_shift) >> 32) as u32;
        // I2F30 * (U6F58 as a 32-bit mantissa) -> Q62
        let half_pixel = |v| scaled(v, g_mantissa, g_shift.saturating_sub(6));
        let forward = scaled(&camera.forward, scale << 1, 0);
        let right = half_pixel(&camera.right);
        Self {
            eye: camera.eye,
            left: stepped(forward, &right, 1 - width as i32),
            right,
            up: half_pixel(&camera.up),
            half_pixel: g,
            width,
            height,
        }
    }

    /// All columns.
    pub(crate) fn columns(&self) -> ColumnRange {
        ColumnRange {
            from: 0,
            to: self.width,
            spacing: 0,
        }
    }

    /// The directions of the rays of line `y`, from left to right.
    #[inline(never)]
    pub(crate) fn line(&self, y: u32) -> ScanlineRays {
        let up = self.height as i32 - 2 * y.min(MAX_SIDE) as i32 - 1;
        let first = stepped(self.left, &self.up, up);
        ScanlineRays {
            // Half a step of a direction, which is then rounded by what is cut off.
            direction: first.map(|c| c.wrapping_add(1 << 31)),
            step: self.right.map(|r| 2 * r),
            remaining: if y < self.height { self.width } else { 0 },
        }
    }

    /// How the plane of the rays of line `y` lies; of the last, beyond it.
    pub(crate) fn row(&self, camera: &Camera, y: u32) -> ScanlinePlane {
        let y = y.min(self.height.saturating_sub(1));
        let up = i64::from(self.height) - 2 * i64::from(y) - 1;
        // Y: Q58 -> Q26
        let height = ((up * self.half_pixel as i64) >> 32) as i32;
        // 1 + Y² in Q48, its root from 1 to 12 in Q24, and the root's reciprocal in Q30.
        let square = (1 << 48) + (height.square() >> 4) as u64;
        let inverse = inverse_length(square);
        let cosine = (inverse.inverse >> 9_u32.saturating_sub(inverse.half_shift)) as i32;
        // Q26 * Q30 -> Q30
        let sine = (height.product(cosine) >> 26) as i32;
        let (forward, up) = (&camera.forward, &camera.up);
        let ScanlineRays {
            direction, step, ..
        } = self.line(y);
        let last = stepped(direction, &step, self.width as i32 - 1);
        ScanlinePlane {
            eye: self.eye,
            ends: [direction, last].map(|end| end.map(|c| Unit::from_bits(high(c)))),
            ahead: sum(forward, cosine, up, sine),
            aside: sum(up, cosine, forward, -sine),
            right: camera.right,
            scale: quotient(square_root(square).into(), self.half_pixel),
            width: self.width as u16,
        }
    }
}

/// `p a + q b`, the factors in Q30.
#[inline(never)]
fn sum(a: &Vec3<Unit>, p: i32, b: &Vec3<Unit>, q: i32) -> Vec3<Unit> {
    // Q60 -> Q28 -> Q30
    a.zip(*b, |a, b| {
        Unit::from_bits(high(a.to_bits().product(p) + b.to_bits().product(q)) << 2)
    })
}

/// The plane of the eye rays of a line.
pub(crate) struct ScanlinePlane {
    pub(crate) eye: Vec3<Length>,
    /// `(f + Y u) / sqrt(1 + Y²)`: the middle of the line.
    pub(crate) ahead: Vec3<Unit>,
    /// `(u - Y f) / sqrt(1 + Y²)`: the plane's normal.
    pub(crate) aside: Vec3<Unit>,
    pub(crate) right: Vec3<Unit>,
    /// The directions of the first and the last ray, not of unit length.
    ends: [Vec3<Unit>; 2],
    /// `sqrt(1 + Y²)`, Q24, in half pixels.
    scale: SoftFloat,
    pub(crate) width: u16,
}

impl ScanlinePlane {
    /// Whether one of the rays may approach a plane.
    pub(crate) fn may_meet(&self, plane: &Plane) -> bool {
        /// More than what rounding a direction does to a cosine: Q60.
        const MARGIN: i64 = 1 << 34;
        let depth = plane.depth(Point::near(self.eye));
        let approaches = |end| {
            let along = along(end, &plane.normal);
            depth > 0 && along > -MARGIN || depth < 0 && along < MARGIN
        };
        self.ends.iter().any(approaches)
    }

    /// Whether all rays approach a plane alike: it is then as many times the length of its
    /// direction away for each.
    #[inline(never)]
    pub(crate) fn is_along(&self, plane: &Plane) -> bool {
        // Where a step to the right is zero, so is the change of a direction, exactly.
        let are_still = |n, right| n == Unit::ZERO || right == Unit::ZERO;
        let along = plane.normal.zip(self.right, are_still);
        along.x && along.y && along.z
    }

    /// The column of the ray that is `n / d` as far to the right as it is ahead,
    /// rounded down, 0 to 65535.
    #[inline(never)]
    pub(crate) fn column(&self, n: i64, d: u64) -> u16 {
        if n == 0 {
            return self.width / 2;
        }
        let ratio = quotient(n.unsigned_abs(), d);
        // 2^30 n / d times 2^30 Q24 / Q58, less 2^32: in half pixels.
        let pixels = SoftFloat {
            mantissa: (wide(ratio.mantissa, self.scale.mantissa) >> 32) as u32,
            exponent: ratio.exponent + self.scale.exponent + 6,
        };
        let pixels = if pixels.exponent > -8 {
            1 << 24
        } else {
            pixels.to_bits()
        };
        let column = (n.signum() * pixels + i64::from(self.width) - 1) >> 1;
        column.clamp(0, u16::MAX.into()) as u16
    }
}

/// How long a direction is along another, Q60.
#[inline(never)]
fn along(direction: &Vec3<Unit>, other: &Vec3<Unit>) -> i64 {
    direction.dot(*other).to_bits()
}

/// Columns of a raster: `from`, and every one that is a multiple of
/// `1 << spacing` further, below `to`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ColumnRange {
    pub(crate) from: u32,
    pub(crate) to: u32,
    pub(crate) spacing: u8,
}

/// The directions of the eye rays along a line.
#[derive(Clone, Debug)]
pub(crate) struct ScanlineRays {
    /// Of the next, not of unit length: Q62 and half a step of Q30.
    direction: Vec3<i64>,
    step: Vec3<i64>,
    remaining: u32,
}

impl ScanlineRays {
    /// Passes over the first `count` rays.
    pub(crate) fn pass(&mut self, count: u32) {
        let steps = count.min(self.remaining) as i32;
        self.direction = stepped(self.direction, &self.step, steps);
        self.remaining = self.remaining.saturating_sub(count);
    }

    /// Those of a whole line that go through some columns.
    pub(crate) fn through(mut self, columns: ColumnRange) -> Self {
        let ColumnRange { from, to, spacing } = columns;
        let to = to.min(self.remaining);
        if from > 0 {
            self.pass(from);
        }
        let round_up = (1 << spacing) - 1;
        Self {
            step: stepped(Vec3::new(0, 0, 0), &self.step, 1 << spacing),
            remaining: (to.saturating_sub(from) + round_up) >> spacing,
            ..self
        }
    }
}

/// The directions, of a length of 7/8 at most.
impl Iterator for ScanlineRays {
    type Item = Vec3<Unit>;

    #[inline(always)]
    fn next(&mut self) -> Option<Vec3<Unit>> {
        self.remaining = self.remaining.checked_sub(1)?;
        let direction = self.direction.map(|c| Unit::from_bits(high(c)));
        self.direction = self.direction.zip(self.step, i64::wrapping_add);
        Some(direction)
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        (self.remaining as usize, Some(self.remaining as usize))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_longest_directions_are_seven_eighths_long() {
        let sizes = [
            (320, 240),
            (1, 1),
            (240, 320),
            (65_535, 65_535),
            (65_535, 1),
            (1, 65_535),
        ];
        for tangent in [1, 1 << 20, 1 << 27, 1 << 28, 45 << 26] {
            let camera = Camera {
                forward: Vec3::new(Unit::ZERO, Unit::ZERO, -Unit::ONE),
                right: Vec3::new(Unit::ONE, Unit::ZERO, Unit::ZERO),
                up: Vec3::new(Unit::ZERO, Unit::ONE, Unit::ZERO),
                tangent,
                ..Camera::default()
            };
            for (width, height) in sizes {
                let view = CameraRays::new(&camera, width, height);
                let length = |x, y| {
                    let mut line = view.line(y);
                    line.pass(x);
                    let direction = line.next().map(|d| d.map(|c| c.to_num::<f64>()));
                    direction.map_or(0.0, |d| (d.x * d.x + d.y * d.y + d.z * d.z).sqrt())
                };
                for (x, y) in [
                    (0, 0),
                    (width - 1, 0),
                    (width - 1, height - 1),
                    (width / 2, 0),
                ] {
                    assert!(length(x, y) <= 0.875, "{tangent} {width}x{height} {x} {y}");
                }
                // A corner of the picture, but for half a pixel.
                if width.min(height) > 200 {
                    assert!(length(0, 0) > 0.86, "{tangent} {width}x{height}");
                }
            }
        }
    }
}
