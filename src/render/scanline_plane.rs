//! The plane that contains the eye and all camera rays of a scanline.

use crate::geometry::{Plane, Point};
use crate::math::{
    Length, Product, SoftFloat, Square, Unit, Vec3, high, inverse_length_outlined, quotient,
    square_root, wide,
};
use crate::prepare::Camera;
use crate::render::camera_rays::CameraRays;

/// The plane that contains the eye and all camera rays of a scanline.
///
/// The formulas of the fields use these names: `f` and `u` are the camera's forward and up vectors,
/// and `g` is half the size of a pixel at distance 1. `Y = (height - 2y - 1) g` is the elevation of
/// line `y`.
pub(crate) struct ScanlinePlane {
    pub(crate) eye: Vec3<Length>,
    /// Unit vector through the middle of the line: `(f + Y u) / sqrt(1 + Y²)`.
    pub(crate) forward: Vec3<Unit>,
    /// Unit normal of the plane: `(u - Y f) / sqrt(1 + Y²)`.
    pub(crate) normal: Vec3<Unit>,
    pub(crate) right: Vec3<Unit>,
    /// Directions of the first and the last ray of the scanline. They do not have unit length.
    ends: [Vec3<Unit>; 2],
    /// Factor that converts the slope of a ray to a column, in half pixels: `sqrt(1 + Y²) / g`. The
    /// slope of a ray is its component along `right` divided by its component along `forward`.
    scale: SoftFloat,
    pub(crate) width: u16,
}

impl ScanlinePlane {
    /// Returns the plane of line `y`, or of the last line if `y` is outside the picture.
    pub(crate) fn new(camera: &Camera, rays: &CameraRays, y: u32) -> Self {
        let elevation = rays.elevation(y);
        // `square` is 1 + Y² in Q48. Its root, from 1 to 12, has Q24. `cosine` is the reciprocal of
        // the root, in Q30.
        let square = (1 << 48) + (elevation.square() >> 4) as u64;
        let inverse = inverse_length_outlined(square);
        let cosine = (inverse.inverse >> 9_u32.saturating_sub(inverse.half_shift)) as i32;
        // The sine is Y times the cosine: the product of Q26 and Q30 is shifted to Q30.
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

    /// Returns true if a ray of the scanline may approach `plane`. Only such a ray can hit the
    /// plane.
    pub(crate) fn may_intersect(&self, plane: &Plane) -> bool {
        /// Upper bound of the rounding error of `cosine`, in Q60.
        const MARGIN: i64 = 1 << 34;
        let depth = plane.depth(Point::near(self.eye));
        let approaches = |end| {
            let cosine = cosine(end, &plane.normal);
            depth > 0 && cosine > -MARGIN || depth < 0 && cosine < MARGIN
        };
        self.ends.iter().any(approaches)
    }

    /// Returns true if the scanline is parallel to `plane`. All rays `eye + t direction` of the
    /// scanline then meet the plane at exactly the same `t`.
    pub(crate) fn is_parallel(&self, plane: &Plane) -> bool {
        // If a component of `right` is zero, all ray directions of the scanline have exactly the
        // same value in that component.
        let contributes_nothing = |n, right| n == Unit::ZERO || right == Unit::ZERO;
        plane
            .normal
            .zip(self.right, contributes_nothing)
            .all(|nothing| nothing)
    }

    /// Returns the column of the ray with slope `n / d`, rounded down and clamped to 0..=65535. The
    /// slope of a ray is its component along `right` divided by its component along `forward`.
    ///
    /// This function is not inlined, because it runs only twice per bounding sphere and scanline.
    #[inline(never)]
    pub(crate) fn column(&self, n: i64, d: u64) -> u16 {
        if n == 0 {
            return self.width / 2;
        }
        let ratio = quotient(n.unsigned_abs(), d);
        // `pixels` is the column, counted in half pixels from the middle of the line. It is
        // computed from the product of `ratio` and `scale`. `ratio` is 2^30 n/d. `scale` is 2^30
        // times a quotient of a Q24 number by a Q58 number, so it is 2^-4 times its true value. The
        // product is therefore 2^26 times the result. Taking the upper word of the product divides
        // it by 2^32. Adding 6 to the exponent multiplies it by 2^6.
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

/// Returns the vector `p a + q b`. The numbers `p` and `q` have Q30.
#[inline(never)]
fn combination(a: &Vec3<Unit>, p: i32, b: &Vec3<Unit>, q: i32) -> Vec3<Unit> {
    // The sum has Q60. Its upper word has Q28 and is shifted to Q30.
    a.zip(*b, |a, b| {
        Unit::from_bits(high(a.to_bits().product(p) + b.to_bits().product(q)) << 2)
    })
}

/// Returns the dot product of a direction and a unit normal, in Q60.
#[inline(never)]
fn cosine(direction: &Vec3<Unit>, normal: &Vec3<Unit>) -> i64 {
    direction.dot(*normal).to_bits()
}
