//! The scale of an animated scene. It fits everything that the tracks reach, so that all frames
//! have the same scale.

use super::Target;
use super::script::Script;
use crate::geometry::{self, Extent, Normalization};
use crate::math::{Color, Real, Vec3, bits, square_root};
use crate::prepare;
use crate::scene::{Camera, Light, Scene, Shape};

impl Script<'_> {
    /// Finds the scale of a scene with all positions and radii that the tracks reach.
    pub(super) fn normalization(&self, scene: &Scene<'_>) -> Normalization {
        let mut extent = prepare::extent(scene);
        self.extend(&mut extent);
        let mut scale = prepare::fit(&extent, scene.objects);
        for shape in self.tracks().flat_map(|track| self.extremes(track.target)) {
            let exponent = geometry::max_exponent(&shape, scale.center, extent.is_point());
            scale = scale.with_exponent_at_most(exponent);
        }
        // The eye may leave the box of the scene on its orbit, but must stay in the near range.
        let orbit = self.orbit(&scene.camera);
        while orbit.is_some_and(|orbit| !scale.has_near(&orbit)) {
            scale.exponent -= 1;
        }
        scale
    }

    /// Returns true if all positions that the tracks reach are in the range of a scale. Preparing
    /// finds a scale for which this is true, but the scale of a compiled scene may have any value.
    pub(super) fn is_within(&self, scale: &Normalization, camera: &Camera) -> bool {
        let mut extent = Extent::new(scale.center.map(Real::from_bits));
        self.extend(&mut extent);
        let orbit = self.orbit(camera);
        scale.contains(&extent) && orbit.is_none_or(|orbit| scale.has_near(&orbit))
    }

    /// Returns the greatest intensities of a light before and during the animation.
    pub(super) fn brightest(&self, index: u16, light: &Light) -> Light {
        let Some(reach) = self.reach(Target::LightColor(index)) else {
            return *light;
        };
        let Vec3 { x, y, z } = reach.high.map(Real::from_bits);
        let brightest = |color: Color<Real>| color.zip(Color::new(x, y, z), Real::max);
        Light {
            diffuse: brightest(light.diffuse),
            specular: brightest(light.specular),
            ..*light
        }
    }

    /// Enlarges an extent to contain all positions and bounded shapes that the tracks reach.
    fn extend(&self, extent: &mut Extent) {
        for target in self.tracks().map(|track| track.target) {
            if let Target::CameraEye | Target::LightPosition(_) = target
                && let Some(reach) = self.reach(target)
            {
                extent.add(&reach);
            }
            for shape in self.extremes(target) {
                geometry::extend(&shape, extent);
            }
        }
    }

    /// Returns the shapes of an animated object at the ends of its ranges: at the corners of the
    /// box of all positions, with the smallest and the greatest radius.
    fn extremes(&self, target: Target) -> impl Iterator<Item = Shape> {
        let still = target.object().and_then(|object| {
            let position = self.reach(Target::ObjectPosition(object));
            let radius = self.reach(Target::ObjectRadius(object));
            Some((self.shape(object)?, position, radius))
        });
        still.into_iter().flat_map(|(still, position, radius)| {
            (0..16).map(move |corner| {
                let mut shape = still;
                if let Some(reach) = position {
                    *shape.position_mut() = reach.corner(corner >> 1);
                }
                if let (Some(reach), Some(value)) = (radius, shape.radius_mut()) {
                    *value = reach.corner(corner & 1).x;
                }
                shape
            })
        })
    }

    /// Returns a box around all positions of the eye on its orbit, or `None` if the camera does
    /// not orbit.
    fn orbit(&self, camera: &Camera) -> Option<Extent> {
        self.tracks()
            .find(|track| track.target == Target::CameraOrbit)?;
        let reach = |target, still| self.reach(target).unwrap_or(Extent::new(still));
        let eye = reach(Target::CameraEye, camera.eye);
        let mut orbit = reach(Target::CameraLookAt, camera.look_at);
        let after = eye.high.zip(orbit.low, |high, low| high - low);
        let before = orbit.high.zip(eye.low, |high, low| high - low);
        let radius = length_at_most(after.zip(before, i64::max));
        orbit.low = orbit.low.map(|c| c - radius);
        orbit.high = orbit.high.map(|c| c + radius);
        Some(orbit)
    }
}

/// Returns an upper bound of the length of a vector whose components are not negative. The margin
/// covers the rounding errors of this function and of orbits.
fn length_at_most(v: Vec3<i64>) -> i64 {
    let shift = (bits(v.x.max(v.y).max(v.z)) - 30).max(0);
    let squared = v.map(|c| ((c >> shift) + 1).unsigned_abs().pow(2));
    (i64::from(square_root(squared.x + squared.y + squared.z)) + 16) << shift
}
