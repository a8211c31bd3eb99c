//! Camera rays of a pinhole camera.
//!
//! Let `f`, `r` and `u` be the camera's forward, right and up vectors. At distance 1 from the eye,
//! half the size of a pixel is `g = tan(fovy / 2) / height`. The ray through the center of pixel
//! (x, y) has the direction `f + X r + Y u`, where `X = (2x + 1 - width) g` and `Y = (height - 2y -
//! 1) g`.

use crate::math::reciprocal_outlined;
use crate::math::{Length, Product, Unit, Vec3, quotient, square_root, wide};
use crate::prepare::Camera;
use crate::render::column_range::ColumnRange;
use crate::render::scanline_rays::{ScanlineRays, offset};

/// Greatest width and height of a picture in pixels.
pub(crate) const MAX_SIDE: u32 = u16::MAX as u32;

/// Generator of the camera rays of a picture.
///
/// Directions are in Q62. They are scaled so that the longest direction has length 7/8. Eight times
/// this length is 7, which is the width of the near range of positions. The near range extends from
/// -3.5 to 3.5 in each coordinate.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CameraRays {
    pub(super) eye: Vec3<Length>,
    /// The sum `f + X r` for the first column. Each line adds its own `Y u` to this sum.
    left: Vec3<i64>,
    /// Vector `g r`: half a pixel to the right.
    right: Vec3<i64>,
    /// Vector `g u`: half a pixel up.
    up: Vec3<i64>,
    /// Half the size of a pixel at distance 1, g, as `U6F58`.
    pub(super) half_pixel: u64,
    pub(crate) width: u32,
    pub(crate) height: u32,
}

impl CameraRays {
    /// Returns the camera rays of a picture of `width` by `height` pixels. The width and the height
    /// are clamped to [`MAX_SIDE`].
    ///
    /// The function is not inlined, because it runs only once per picture.
    #[inline(never)]
    pub(crate) fn new(camera: &Camera, width: u32, height: u32) -> Self {
        let (width, height) = (width.min(MAX_SIDE), height.min(MAX_SIDE));
        // g is tangent / height, computed as the product of a `U4F28` and a reciprocal in `U1F31`,
        // and shifted to `U6F58`.
        let shift = height.max(1).leading_zeros();
        let g = wide(camera.tangent, reciprocal_outlined(height.max(1) << shift)) >> (33 - shift);
        let scale = direction_scale(g, [width, height]);
        // Computes the product of `g` and `scale`, and then converts this product to a 32-bit
        // mantissa and a shift.
        let scaled_g = (wide((g >> 32) as u32, scale) << 1) + (wide(g as u32, scale) >> 31);
        let g_shift = scaled_g.max(1).leading_zeros();
        let g_mantissa = ((scaled_g << g_shift) >> 32) as u32;
        // Multiplies a unit vector, in `I2F30`, by the scaled g and shifts the product to Q62.
        let half_pixel = |v| scaled(v, g_mantissa, g_shift.saturating_sub(6));
        let forward = scaled(&camera.forward, scale << 1, 0);
        let right = half_pixel(&camera.right);
        Self {
            eye: camera.eye,
            left: offset(forward, &right, 1 - width as i32),
            right,
            up: half_pixel(&camera.up),
            half_pixel: g,
            width,
            height,
        }
    }

    /// Returns all columns of the picture.
    pub(crate) fn columns(&self) -> ColumnRange {
        ColumnRange {
            from: 0,
            to: self.width,
            spacing: 0,
        }
    }

    /// Returns the directions of the camera rays of line `y`, from left to right. The iterator is
    /// empty if `y` is outside the picture.
    ///
    /// The function is not inlined, because it runs only once per scanline.
    #[inline(never)]
    pub(crate) fn line(&self, y: u32) -> ScanlineRays {
        let up = self.height as i32 - 2 * y.min(MAX_SIDE) as i32 - 1;
        ScanlineRays::new(
            offset(self.left, &self.up, up),
            self.right.map(|r| 2 * r),
            if y < self.height { self.width } else { 0 },
        )
    }

    /// Returns the elevation `(height - 2y - 1) g` of line `y`, in Q26. A line below the picture
    /// gets the elevation of the last line in the picture.
    pub(super) fn elevation(&self, y: u32) -> i32 {
        let y = y.min(self.height.saturating_sub(1));
        let up = i64::from(self.height) - 2 * i64::from(y) - 1;
        // The shift converts Q58 to Q26.
        ((up * self.half_pixel as i64) >> 32) as i32
    }
}

/// Returns the factor that scales the longest direction of a picture to length 7/8. The factor is a
/// `U1F31` below 1.
///
/// `g` is half the size of a pixel at distance 1 from the eye. The longest direction goes through a
/// corner of the picture. Its length is at most `sqrt(1 + (width g)² + (height g)²)`.
fn direction_scale(g: u64, [width, height]: [u32; 2]) -> u32 {
    let sides = [width, height].map(|side| ((g >> 30) + 1) * u64::from(side));
    // Lengths are in Q28 and squares of lengths in Q56. If the squares would overflow, all lengths
    // are first shifted down by `coarser` bits.
    let coarser = (64 - (sides[0] | sides[1]).leading_zeros()).saturating_sub(30);
    let square = |side| square_above(side, coarser);
    let longest_squared = square(1 << 28) + square(sides[0]) + square(sides[1]);
    let longest = u64::from(square_root(longest_squared)) << coarser;
    quotient(7 << 26, longest).to_bits() as u32
}

/// Returns `v * factor / 2^shift`, rounded down.
#[inline(never)]
fn scaled(v: &Vec3<Unit>, factor: u32, shift: u32) -> Vec3<i64> {
    v.map(|c| c.to_bits().product(factor) >> shift)
}

/// Returns the square of `side / 2^shift`, rounded up.
fn square_above(side: u64, shift: u32) -> u64 {
    ((side >> shift) + 1).pow(2)
}

#[cfg(test)]
mod tests {
    use super::*;

    const TANGENTS: [u32; 5] = [1, 1 << 20, 1 << 27, 1 << 28, 45 << 26];
    const SIZES: [(u32, u32); 6] = [
        (320, 240),
        (1, 1),
        (240, 320),
        (65_535, 65_535),
        (65_535, 1),
        (1, 65_535),
    ];

    fn camera(tangent: u32) -> Camera {
        Camera {
            forward: Vec3::new(Unit::ZERO, Unit::ZERO, -Unit::ONE),
            right: Vec3::new(Unit::ONE, Unit::ZERO, Unit::ZERO),
            up: Vec3::new(Unit::ZERO, Unit::ONE, Unit::ZERO),
            tangent,
            ..Camera::default()
        }
    }

    fn length(rays: &CameraRays, x: u32, y: u32) -> f64 {
        let mut line = rays.line(y);
        line.skip_rays(x);
        let direction = line.next().map(|d| d.map(|c| c.to_num::<f64>()));
        direction.map_or(0.0, |d| (d.x * d.x + d.y * d.y + d.z * d.z).sqrt())
    }

    #[test]
    fn longest_direction_has_length_seven_eighths() {
        for tangent in TANGENTS {
            for (width, height) in SIZES {
                let rays = CameraRays::new(&camera(tangent), width, height);
                let (right, bottom) = (width - 1, height - 1);
                for (x, y) in [(0, 0), (right, 0), (right, bottom), (width / 2, 0)] {
                    let length = length(&rays, x, y);
                    assert!(length <= 0.875, "{tangent} {width}x{height} {x} {y}");
                }
                // The ray through the center of the corner pixel is half a pixel away from the
                // corner of the picture. The direction of this ray is therefore slightly shorter
                // than 7/8.
                if width.min(height) > 200 {
                    let length = length(&rays, 0, 0);
                    assert!(length > 0.86, "{tangent} {width}x{height}");
                }
            }
        }
    }
}
