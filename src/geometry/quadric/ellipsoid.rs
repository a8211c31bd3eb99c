use super::super::extent::Extent;
use super::super::normalization::Normalization;
use super::super::primitive::AuthoredShape;
use super::super::{limits, valid};
use super::form::QuadricForm;
use super::placed::Placed;
use super::quadratic::{Quadratic, moment, scaled_by_axis};
use super::ratio::unit_ratio;
use crate::archive;
use crate::archive::{Archive, Fields};
use crate::math::{Length, Product, Real, Square, Unit, Vec3, quotient, upper_product};
use crate::observer::ShapeKind;
use crate::scene::{SceneError, SceneItem};

/// The longest radius of an ellipsoid is at most 2^8 times the shortest radius.
const FLATTEST: u32 = 8;

/// An ellipsoid in world units.
pub(in super::super) struct Authored {
    pub(in super::super) center: Vec3<Real>,
    pub(in super::super) radii: Vec3<Real>,
}

impl Authored {
    fn shortest(&self) -> Real {
        self.radii.x.min(self.radii.y).min(self.radii.z)
    }
}

impl AuthoredShape for Authored {
    type Prepared = Placed<Ellipsoid>;

    fn validate(&self, item: SceneItem) -> Result<(), SceneError> {
        limits::point(item, "center", self.center)?;
        let (shortest, longest) = (
            self.shortest(),
            self.radii.x.max(self.radii.y).max(self.radii.z),
        );
        limits::size(item, "radii", shortest)?;
        limits::size(item, "radii", longest)?;
        limits::range(item, "radii", shortest, [longest >> FLATTEST, longest])
    }

    fn extend(&self, extent: &mut Extent) {
        extent.add_box(self.center, self.radii.map(Real::to_bits));
    }

    fn prepare(
        &self,
        normalization: &Normalization,
        item: SceneItem,
    ) -> Result<Placed<Ellipsoid>, SceneError> {
        let shortest = self.shortest();
        limits::resolvable_size(item, "radii", shortest, normalization)?;
        Ok(Placed {
            center: normalization.point(self.center),
            clamp: None,
            form: Ellipsoid {
                axis_scale: self.radii.map(|radius| unit_ratio(shortest, radius)),
                radius: normalization.size(shortest),
            },
        })
    }
}

/// An ellipsoid, stored as a sphere with the shortest radius. Multiplying coordinates by
/// `axis_scale` turns the ellipsoid into that sphere.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Ellipsoid {
    /// Shortest radius divided by the radius along each axis, at most 1.
    pub(super) axis_scale: Vec3<Unit>,
    /// Shortest radius.
    pub(super) radius: Length,
}

impl Ellipsoid {
    fn scaled(&self, v: Vec3<Length>) -> Vec3<Length> {
        scaled_by_axis(v.map(Length::to_bits), self.axis_scale).map(Length::from_bits)
    }
}

impl QuadricForm for Ellipsoid {
    const KIND: ShapeKind = ShapeKind::Ellipsoid;
    const TAG: u8 = 3;

    /// Returns the longest radius.
    fn max_radius(&self, _: Length) -> Option<Length> {
        let Vec3 { x, y, z } = self.axis_scale;
        let smallest = x.min(y).min(z).to_bits() as u64;
        quotient(self.radius.to_bits() as u64, smallest).near()
    }

    /// Returns the equation of a ray and the sphere in scaled coordinates.
    ///
    /// The discriminant is `r² |d|² - |o × d|²` (Lagrange's identity), where r is the radius, o the
    /// origin of the ray and d its direction. This expression keeps bits that `b² - a c` loses.
    fn quadratic(&self, offset: Vec3<Length>, direction: Vec3<Unit>, _: u8) -> Quadratic {
        let o = self.scaled(offset);
        let d = scaled_by_axis(direction.map(Unit::to_bits), self.axis_scale).map(Unit::from_bits);
        let a = d.dot(d).to_bits();
        let radius_squared = self.radius.square().to_bits();
        let reach = upper_product(radius_squared as u64, a as u64, 4) as i64;
        Quadratic {
            a,
            b: o.along(d).to_bits(),
            c: o.squared().to_bits() - radius_squared,
            discriminant: reach - moment(o, d).squared().to_bits(),
        }
    }

    fn gradient(&self, offset: Vec3<Length>, _: u8) -> Vec3<i64> {
        self.scaled(offset)
            .zip(self.axis_scale, |c, k| c.product(k).to_bits())
    }

    fn is_valid(&self) -> bool {
        let scale = Unit::DELTA..=Unit::ONE;
        self.axis_scale.all(|c| scale.contains(&c)) && valid::is_size(self.radius)
    }
}

impl Fields for Ellipsoid {
    fn visit(&mut self, archive: &mut impl Archive) {
        archive::vector(&mut self.axis_scale, archive);
        archive::fixed(&mut self.radius, archive);
    }
}
