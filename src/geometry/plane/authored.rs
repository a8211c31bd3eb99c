use super::super::clip_box::ClipBox;
use super::super::extent::Extent;
use super::super::limits;
use super::super::normalization::Normalization;
use super::super::primitive::AuthoredShape;
use super::Plane;
use crate::math::{Length, Real, Vec3, bits, direction};
use crate::scene::{self, SceneError, SceneItem, SceneProblem};

/// A plane in world units.
pub(in super::super) struct Authored {
    pub(in super::super) normal: Vec3<Real>,
    pub(in super::super) point: Vec3<Real>,
    pub(in super::super) bounds: scene::ClipBox,
}

impl Authored {
    fn bounds(&self) -> [Option<[Real; 2]>; 3] {
        [self.bounds.x, self.bounds.y, self.bounds.z]
    }
}

impl AuthoredShape for Authored {
    type Prepared = Plane;

    fn validate(&self, item: SceneItem) -> Result<(), SceneError> {
        limits::point(item, "normal", self.normal)?;
        limits::point(item, "point", self.point)?;
        ["bounds.x", "bounds.y", "bounds.z"]
            .into_iter()
            .zip(self.bounds())
            .try_for_each(|(field, bound)| {
                bound.map_or(Ok(()), |bound| limits::interval(item, field, bound))
            })
    }

    /// Adds nothing to the extent, so unbounded surfaces do not affect the scale. Otherwise a
    /// large floor would reduce the precision of the objects on it.
    fn extend(&self, _: &mut Extent) {}

    /// Returns the largest exponent of the scale at which the ends of the clip box are within
    /// ±4. In a scene without bounded geometry the point of the plane must also be within ±2.
    fn max_exponent(&self, center: Vec3<i64>, is_alone: bool) -> i32 {
        let mut exponent = i32::MAX;
        for (bound, center) in self
            .bounds()
            .into_iter()
            .zip([center.x, center.y, center.z])
        {
            for end in bound.into_iter().flatten() {
                exponent = exponent.min(34 - bits(end.to_bits() - center));
            }
        }
        if is_alone {
            let way = self.point.map(Real::to_bits).zip(center, |p, c| p - c);
            exponent = exponent.min(33 - bits(way.x).max(bits(way.y)).max(bits(way.z)));
        }
        exponent
    }

    fn prepare(&self, normalization: &Normalization, item: SceneItem) -> Result<Plane, SceneError> {
        let Some(normal) = direction(self.normal.map(Real::to_bits)) else {
            return limits::error(item, "normal", SceneProblem::NoDirection);
        };
        let Some(offset) = normalization.offset(normal, self.point) else {
            return limits::error(item, "point", normalization.offset_problem());
        };
        let center = normalization.center;
        let side = |bound: Option<[Real; 2]>, center: i64| {
            bound.map_or([Length::MIN, Length::MAX], |bound| {
                bound.map(|b| Length::from_bits(normalization.length(b.to_bits() - center) as i32))
            })
        };
        let [x, y, z] = [
            side(self.bounds.x, center.x),
            side(self.bounds.y, center.y),
            side(self.bounds.z, center.z),
        ];
        let clip_box = (self.bounds != scene::ClipBox::NONE).then_some(ClipBox {
            low: Vec3::new(x[0], y[0], z[0]),
            high: Vec3::new(x[1], y[1], z[1]),
        });
        Ok(Plane::new(normal, offset, clip_box))
    }
}
