use super::super::extent::Extent;
use super::super::normalization::Normalization;
use super::super::primitive::AuthoredShape;
use super::super::{limits, valid};
use super::form::QuadricForm;
use super::placed::Placed;
use super::quadratic::Quadratic;
use crate::archive;
use crate::archive::{Archive, Fields};
use crate::math::{Length, Product, Real, Square, Unit, Vec3, round_length, upper_product};
use crate::observer::ShapeKind;
use crate::scene::{SceneError, SceneItem};

/// A cylinder in world units.
pub(in super::super) struct Authored {
    pub(in super::super) origin: Vec3<Real>,
    pub(in super::super) radius: Real,
    pub(in super::super) y: Option<[Real; 2]>,
}

impl AuthoredShape for Authored {
    type Prepared = Placed<Cylinder>;

    fn validate(&self, item: SceneItem) -> Result<(), SceneError> {
        limits::point(item, "origin", self.origin)?;
        limits::size(item, "radius", self.radius)?;
        self.y.map_or(Ok(()), |y| limits::interval(item, "y", y))
    }

    /// Adds the cylinder to the extent of the scene. An unbounded cylinder adds only one circle, at
    /// the lowest height that the extent has so far.
    fn extend(&self, extent: &mut Extent) {
        let radii = [self.radius.to_bits(); 2];
        match self.y {
            Some(y) => extent.add_rings(self.origin, y, radii),
            None => {
                let origin = Vec3 {
                    y: Real::from_bits(extent.low.y),
                    ..self.origin
                };
                extent.add_rings(origin, [Real::ZERO; 2], radii);
            }
        }
    }

    fn prepare(
        &self,
        normalization: &Normalization,
        item: SceneItem,
    ) -> Result<Placed<Cylinder>, SceneError> {
        limits::resolvable_size(item, "radius", self.radius, normalization)?;
        let form = Cylinder {
            radius: normalization.size(self.radius),
        };
        Ok(match self.y {
            Some(y) => Placed::clamped(self.origin, y, normalization, form),
            None => Placed {
                // The center of an unbounded cylinder may be at any height.
                center: Vec3 {
                    y: Length::ZERO,
                    ..normalization.point(self.origin)
                },
                clamp: None,
                form,
            },
        })
    }
}

/// A cylinder around the y axis.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Cylinder {
    pub(super) radius: Length,
}

impl QuadricForm for Cylinder {
    const KIND: ShapeKind = ShapeKind::Cylinder;
    const TAG: u8 = 4;

    fn max_radius(&self, _: Length) -> Option<Length> {
        Some(self.radius)
    }

    /// Returns the equation of a ray and a circle. The ray and the cylinder are projected to the
    /// plane of x and z, where the cylinder is a circle. The discriminant is `r² |d|² - (o × d)²`,
    /// where r is the radius, o the origin of the ray and d its direction.
    fn quadratic(&self, offset: Vec3<Length>, direction: Vec3<Unit>, shift: u8) -> Quadratic {
        let (o, d) = (offset, direction);
        let a = (d.x.square() + d.z.square()).to_bits();
        let radius_squared = self.radius.square().to_bits() >> (2 * shift);
        let reach = upper_product(radius_squared as u64, a as u64, 4) as i64;
        let cross = o.x.product(d.z) - o.z.product(d.x);
        let cross = round_length::<30>(cross.to_bits());
        Quadratic {
            a,
            b: (o.x.product(d.x) + o.z.product(d.z)).to_bits(),
            c: (o.x.square() + o.z.square()).to_bits() - radius_squared,
            discriminant: reach - cross.square().to_bits(),
        }
    }

    fn gradient(&self, offset: Vec3<Length>, _: u8) -> Vec3<i64> {
        Vec3::new(offset.x, Length::ZERO, offset.z).map(|c| c.to_bits().into())
    }

    fn is_valid(&self) -> bool {
        valid::is_size(self.radius)
    }
}

impl Fields for Cylinder {
    fn visit(&mut self, archive: &mut impl Archive) {
        archive::fixed(&mut self.radius, archive);
    }
}
