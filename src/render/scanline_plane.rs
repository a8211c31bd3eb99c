//! Plane through the eye that contains the camera rays of a scanline.

use crate::geometry::{Plane, Point};
use crate::math::{
    Length, Product, SoftFloat, Square, Unit, Vec3, high, inverse_length_outlined, quotient,
    square_root, wide,
};
use crate::prepare::Camera;
use crate::render::camera_rays::CameraRays;

/// Plane of the camera rays of a scanline, with `Y` as in [`CameraRays`].
pub(crate) struct ScanlinePlane {
    pub(crate) eye: Vec3<Length>,
    /// Unit vector through the middle of the line: `(f + Y u) / sqrt(1 + Y²)`.
    pub(crate) forward: Vec3<Unit>,
    /// Unit normal of the plane: `(u - Y f) / sqrt(1 + Y²)`.
    pub(crate) normal: Vec3<Unit>,
    pub(crate) right: Vec3<Unit>,
    /// Directions of the first and the last ray, not of unit length.
    ends: [Vec3<Unit>; 2],
    /// Half pixels per unit of slope `right / forward`: `sqrt(1 + Y²) / g`.
    scale: SoftFloat,
    pub(crate) width: u16,
}

impl ScanlinePlane {
    /// Returns the plane of line `y`, or of the last line if `y` is outside the picture.
    pub(crate) fn new(camera: &Camera, rays: &CameraRays, y: u32) -> Self {
        let elevation = rays.elevation(y);
        // 1 + Y² in Q48, its root (1 to 12) in Q24, and the inverse of the root in Q30.
        let square = (1 << 48) + (elevation.square() >> 4) as u64;
        let inverse = inverse_length_outlined(square);
        let cosine = (inverse.inverse >> 9_u32.saturating_sub(inverse.half_shift)) as i32;
        // Q26 * Q30 -> Q30
        let sine = (elevation.product(cosine) >> 26) as i32;
        let (forward, up) = (&camera.forward, &camera.up);
        let y = y.min(rays.height.saturating_sub(1));
        Self {
            eye: rays.eye,
            ends: rays.line(y).ends(rays.width as i32 - 1),
            forward: combination(forward, cosine, up, sine),
            normal: combination(up, cosine, forward, -sine),
            right: camera.right,
            scale: quotient(square_root(square).into(), rays.half_pixel),
            width: rays.width as u16,
        }
    }

    /// Returns true if a ray of the scanline may approach the plane.
    pub(crate) fn may_intersect(&self, plane: &Plane) -> bool {
        /// Bound of the rounding error of `cosine`, Q60.
        const MARGIN: i64 = 1 << 34;
        let depth = plane.depth(Point::near(self.eye));
        let approaches = |end| {
            let cosine = cosine(end, &plane.normal);
            depth > 0 && cosine > -MARGIN || depth < 0 && cosine < MARGIN
        };
        self.ends.iter().any(approaches)
    }

    /// Returns true if the scanline runs parallel to the plane, so that all rays have exactly the
    /// same ray parameter t at the plane.
    pub(crate) fn is_parallel(&self, plane: &Plane) -> bool {
        // A zero component of `right` stays exactly zero in the steps from ray to ray.
        let contributes_nothing = |n, right| n == Unit::ZERO || right == Unit::ZERO;
        plane
            .normal
            .zip(self.right, contributes_nothing)
            .all(|nothing| nothing)
    }

    /// Returns the column of the ray with slope `n / d` (right over forward), rounded down and
    /// clamped to 0..=65535.
    ///
    /// Out of line: runs twice per bounding sphere and scanline.
    #[inline(never)]
    pub(crate) fn column(&self, n: i64, d: u64) -> u16 {
        if n == 0 {
            return self.width / 2;
        }
        let ratio = quotient(n.unsigned_abs(), d);
        // Half pixels: 2^30 n/d * 2^30 Q24/Q58, with the exponent lowered by 32.
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

/// Returns `p a + q b`, with `p` and `q` in Q30.
#[inline(never)]
fn combination(a: &Vec3<Unit>, p: i32, b: &Vec3<Unit>, q: i32) -> Vec3<Unit> {
    // Q60 -> Q28 -> Q30
    a.zip(*b, |a, b| {
        Unit::from_bits(high(a.to_bits().product(p) + b.to_bits().product(q)) << 2)
    })
}

/// Returns the dot product of a direction and a unit normal, Q60.
#[inline(never)]
fn cosine(direction: &Vec3<Unit>, normal: &Vec3<Unit>) -> i64 {
    direction.dot(*normal).to_bits()
}
