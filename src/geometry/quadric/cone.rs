use super::super::extent::Extent;
use super::super::limits::{FARTHEST, SMALLEST};
use super::super::normalization::Normalization;
use super::super::primitive::AuthoredShape;
use super::super::{limits, valid};
use super::form::QuadricForm;
use super::placed::{Placed, middle};
use super::quadratic::{Quadratic, moment, scaled_by_axis};
use super::ratio::unit_ratio;
use crate::archive;
use crate::archive::{Archive, Fields};
use crate::math::{
    Length, Product, Real, Square, Unit, Vec3, divide, multiply, quotient, round_length,
};
use crate::observer::ShapeKind;
use crate::scene::{SceneError, SceneItem};

/// The height and the radius of a cone differ by a factor of at most 2^10.
const STEEPEST: u32 = 10;

/// A cone in world units.
pub(in super::super) struct Authored {
    pub(in super::super) origin: Vec3<Real>,
    pub(in super::super) radius: Real,
    pub(in super::super) height: Real,
    pub(in super::super) y: Option<[Real; 2]>,
}

impl Authored {
    /// Returns the radius of the cone at the height `y`, as the raw bits of a [`Real`]. The radius
    /// is negative beyond the apex. The caller ensures that the radius is in the range of a
    /// [`Real`].
    #[inline(never)]
    fn radius_at(&self, y: Real) -> i64 {
        let product = i128::from(self.radius.to_bits()) * i128::from((self.height - y).to_bits());
        divide(product, self.height.to_bits()) as i64
    }

    /// Returns the prepared cone. The origin of its coordinates is at the height `middle`.
    #[inline(never)]
    fn form(&self, middle: Real, normalization: &Normalization) -> Cone {
        let (radius, height) = (self.radius, self.height);
        let half = Unit::ONE / 2;
        if radius <= height.abs() {
            Cone {
                radial: half,
                axial: unit_ratio(radius, height) / 2,
                radius: normalization.half_size(self.radius_at(middle)),
            }
        } else {
            let sign = height.to_bits().signum();
            Cone {
                radial: unit_ratio(height.abs(), radius) / 2,
                axial: half * sign as i32,
                radius: normalization.half_size((height - middle).to_bits() * sign),
            }
        }
    }
}

impl AuthoredShape for Authored {
    type Prepared = Placed<Cone>;

    fn validate(&self, item: SceneItem) -> Result<(), SceneError> {
        let Self {
            origin,
            radius,
            height,
            y,
        } = *self;
        limits::point(item, "origin", origin)?;
        limits::size(item, "radius", radius)?;
        let least = (radius >> STEEPEST).max(SMALLEST);
        let most = radius.min(FARTHEST >> STEEPEST) << STEEPEST;
        let heights = if height < 0 {
            [-most, -least]
        } else {
            [least, most]
        };
        limits::range(item, "height", height, heights)?;
        let Some(y) = y else { return Ok(()) };
        limits::interval(item, "y", y)?;
        // The clamp is the interval of y. At both of its ends, the radius of the cone must be at
        // most the largest coordinate.
        let steepness = divide(i128::from(height.to_bits().abs()) << 32, radius.to_bits());
        let reach = multiply(FARTHEST, Real::from_bits(steepness as i64)).min(FARTHEST);
        let within = [height - reach, height + reach];
        y.into_iter()
            .try_for_each(|y| limits::range(item, "y", y, within))
    }

    /// Adds the cone to the extent of the scene. An unbounded cone adds only its part from the base
    /// to the apex.
    fn extend(&self, extent: &mut Extent) {
        let y = self.y.unwrap_or([Real::ZERO, self.height]);
        extent.add_rings(self.origin, y, y.map(|y| self.radius_at(y).abs()));
    }

    fn prepare(
        &self,
        normalization: &Normalization,
        item: SceneItem,
    ) -> Result<Placed<Cone>, SceneError> {
        limits::resolvable_size(item, "radius", self.radius, normalization)?;
        limits::resolvable_size(item, "height", self.height, normalization)?;
        Ok(match self.y {
            Some(y) => {
                let form = self.form(middle(y), normalization);
                Placed::clamped(self.origin, y, normalization, form)
            }
            None => Placed {
                center: normalization.point(self.origin),
                clamp: None,
                form: self.form(Real::ZERO, normalization),
            },
        })
    }
}

/// A cone around the y axis. Its coordinates are scaled so that the cone has a slope of one.
///
/// The equation is `x² + z² = v²`, where x and z are multiplied by `radial`, and
/// `v = radius - axial * y`. All scaled coordinates are halved, so that every vector is shorter
/// than 8.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Cone {
    /// Factor of x and z: 1/2, or less for a flat cone.
    pub(super) radial: Unit,
    /// Factor of y: 1/2, or less for a steep cone. The factor is negative if the radius grows with
    /// y.
    pub(super) axial: Unit,
    /// Scaled radius at the height of the center. The radius is negative if the center is beyond
    /// the apex.
    pub(super) radius: Length,
}

impl Cone {
    fn axis_scale(&self) -> Vec3<Unit> {
        Vec3::new(self.radial, self.axial, self.radial)
    }

    /// Returns the scaled coordinates x, v and z of a point, in units of `2^(shift - 28)`.
    fn scaled(&self, v: Vec3<Length>, shift: u8) -> Vec3<Length> {
        let v = scaled_by_axis(v.map(Length::to_bits), self.axis_scale()).map(Length::from_bits);
        Vec3::new(v.x, (self.radius >> u32::from(shift)) - v.y, v.z)
    }
}

impl QuadricForm for Cone {
    const KIND: ShapeKind = ShapeKind::Cone;
    const TAG: u8 = 5;

    fn max_radius(&self, height: Length) -> Option<Length> {
        let growth = round_length::<30>(height.product(self.axial.abs()).to_bits());
        let scaled = self.radius.abs() + growth;
        quotient(scaled.to_bits().max(1) as u64, self.radial.to_bits() as u64).near()
    }

    /// Returns the coefficients of the equation `x² + z² - v² = 0` along a ray.
    ///
    /// The discriminant is computed from the cross product of the scaled origin and the scaled
    /// direction. It is the sum of the squared components for x and z, minus the squared component
    /// for v.
    fn quadratic(&self, offset: Vec3<Length>, direction: Vec3<Unit>, shift: u8) -> Quadratic {
        let o = self.scaled(offset, shift);
        let d = scaled_by_axis(direction.map(Unit::to_bits), self.axis_scale());
        let d = d.map(Unit::from_bits);
        let d = Vec3::new(d.x, -d.y, d.z);
        let cross = moment(o, d).map(|c| c.square());
        Quadratic {
            a: (d.x.square() + d.z.square() - d.y.square()).to_bits(),
            b: (o.x.product(d.x) + o.z.product(d.z) - o.y.product(d.y)).to_bits(),
            c: (o.x.square() + o.z.square() - o.y.square()).to_bits(),
            discriminant: (cross.x + cross.z - cross.y).to_bits(),
        }
    }

    fn gradient(&self, offset: Vec3<Length>, shift: u8) -> Vec3<i64> {
        self.scaled(offset, shift)
            .zip(self.axis_scale(), |c, k| c.product(k).to_bits())
    }

    fn is_valid(&self) -> bool {
        let half = Unit::ONE / 2;
        (Unit::DELTA..=half).contains(&self.radial)
            && self.axial != 0
            && valid::is_within(self.axial, half)
            && valid::is_within(self.radius, Length::ONE)
    }
}

impl Fields for Cone {
    fn visit(&mut self, archive: &mut impl Archive) {
        archive::fixed(&mut self.radial, archive);
        archive::fixed(&mut self.axial, archive);
        archive::fixed(&mut self.radius, archive);
    }
}
