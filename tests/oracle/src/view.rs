//! Camera rays.

use crate::Float;
use crate::ray::Ray;
use crate::scene::Camera;
use crate::vec3::Vec3;

/// Camera ray generator of a picture.
#[derive(Clone, Copy, Debug)]
pub struct View<F> {
    eye: Vec3<F>,
    /// Direction through the center of the top left pixel, not a unit vector.
    corner: Vec3<F>,
    /// Change of the direction per pixel to the right.
    right: Vec3<F>,
    /// Change of the direction per pixel down.
    down: Vec3<F>,
}

impl<F: Float> Camera<F> {
    /// Returns the ray generator for a picture of this size.
    pub fn view(&self, width: u32, height: u32) -> View<F> {
        let (w, h) = (F::from_u32(width), F::from_u32(height));
        let half = F::lit(0.5);
        let forward = (self.look_at - self.eye).unit();
        let right = forward.cross(self.up).unit();
        let up = right.cross(forward);
        // At distance 1 the picture is 2·tan(fovy/2) high. Pixels are square.
        let tangent = (self.fovy_deg * F::lit(core::f64::consts::PI / 360.0)).tan();
        let pixel = (tangent + tangent) / h;
        let x = (half - w * half) * pixel;
        let y = (h * half - half) * pixel;
        View {
            eye: self.eye,
            corner: forward + right * x + up * y,
            right: right * pixel,
            down: up * -pixel,
        }
    }
}

impl<F: Float> View<F> {
    /// Returns the ray through the center of a pixel.
    pub(crate) fn ray(&self, x: u32, y: u32) -> Ray<F> {
        let (x, y) = (F::from_u32(x), F::from_u32(y));
        Ray {
            origin: self.eye,
            direction: (self.corner + self.right * x + self.down * y).unit(),
            start: None,
        }
    }
}
