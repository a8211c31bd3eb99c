use fixed::types::U0F32;

use super::super::extent::Extent;
use super::super::limits;
use super::super::normalization::Normalization;
use super::super::primitive::AuthoredShape;
use super::parameters::{MAX_DEPTH, Sphereflake, SphereflakeParams, bounding_radius};
use crate::math::{Real, Unit, Vec3, direction, multiply};
use crate::scene::{SceneError, SceneItem, SceneProblem};

/// A sphereflake in world units.
pub(in super::super) struct Authored {
    pub(in super::super) center: Vec3<Real>,
    pub(in super::super) radius: Real,
    pub(in super::super) depth: u8,
    pub(in super::super) ratio: Real,
    pub(in super::super) frame: [Vec3<Real>; 3],
}

impl Authored {
    /// Returns the radius of a sphere divided by that of its parent, which is below 1.
    fn ratio(&self) -> U0F32 {
        U0F32::from_bits(self.ratio.to_bits() as u32)
    }

    /// Checks that the smallest spheres of the flake are large enough for the resolution of the
    /// scene.
    #[inline(never)]
    fn check_smallest_spheres(
        &self,
        normalization: &Normalization,
        item: SceneItem,
    ) -> Result<(), SceneError> {
        let least = limits::least_size(normalization).to_bits();
        let ratio = i128::from(self.ratio().to_bits());
        let mut radius = self.radius.to_bits();
        let mut deepest = 0;
        while deepest < self.depth {
            radius = ((i128::from(radius) * ratio) >> 32) as i64;
            if radius < least {
                break;
            }
            deepest += 1;
        }
        limits::range(
            item,
            "depth",
            self.depth.into(),
            [Real::ZERO, deepest.into()],
        )
    }
}

impl AuthoredShape for Authored {
    type Prepared = Sphereflake;

    fn validate(&self, item: SceneItem) -> Result<(), SceneError> {
        const RATIOS: [Real; 2] = [Real::lit("0.1"), Real::lit("0.5")];
        limits::point(item, "center", self.center)?;
        limits::size(item, "radius", self.radius)?;
        let depths = [Real::ZERO, MAX_DEPTH.into()];
        limits::range(item, "depth", self.depth.into(), depths)?;
        limits::range(item, "ratio", self.ratio, RATIOS)?;
        self.frame
            .into_iter()
            .try_for_each(|row| limits::point(item, "frame", row))
    }

    fn extend(&self, extent: &mut Extent) {
        let bound = bounding_radius(self.ratio(), self.depth);
        let reach = i128::from(self.radius.to_bits()) * i128::from(bound.to_bits());
        let reach = (reach >> 29) as i64 + 1;
        extent.add_box(self.center, Vec3::new(reach, reach, reach));
    }

    fn prepare(
        &self,
        normalization: &Normalization,
        item: SceneItem,
    ) -> Result<Sphereflake, SceneError> {
        limits::resolvable_size(item, "radius", self.radius, normalization)?;
        self.check_smallest_spheres(normalization, item)?;
        let Some(frame) = orthonormal(self.frame) else {
            return limits::error(item, "frame", SceneProblem::NotOrthonormal);
        };
        Ok(Sphereflake::new(SphereflakeParams {
            center: normalization.point(self.center),
            frame,
            radius: normalization.fraction(self.radius),
            ratio: self.ratio(),
            depth: self.depth,
        }))
    }
}

/// Returns the axes u and v of a frame, corrected to be exactly orthonormal. Returns `None` if the
/// three rows of the frame are not nearly orthonormal or not right-handed.
#[inline(never)]
fn orthonormal([u, v, w]: [Vec3<Real>; 3]) -> Option<[Vec3<Unit>; 2]> {
    /// Tolerance for rows that are written with three digits.
    const MARGIN: Real = Real::lit("0.001");
    let is_unit = |v| (dot(v, v).saturating_sub(Real::ONE)).abs() < 2 * MARGIN;
    let are_orthogonal = |a, b| dot(a, b).abs() < MARGIN;
    if ![u, v, w].into_iter().all(is_unit) || !are_orthogonal(u, v) {
        return None;
    }
    let [u, v, w] = [u, v, w].map(|row| direction(row.map(Real::to_bits)));
    let (u, v, w) = (u?, v?, w?);
    let exact_w = direction(u.cross(v))?;
    // The exact axis w must be close to the given row: the dot product of the two must be at
    // least 1 - 2^-6.
    if exact_w.dot(w).to_bits() < (1 << 60) - (1 << 50) * 16 {
        return None;
    }
    Some([u, direction(exact_w.cross(u))?])
}

#[inline(never)]
fn dot(a: Vec3<Real>, b: Vec3<Real>) -> Real {
    let sum = a.zip(b, multiply);
    sum.x.saturating_add(sum.y).saturating_add(sum.z)
}
