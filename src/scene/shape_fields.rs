//! The fields of an authored shape in a compiled scene. They are stored for the objects that an
//! animation moves, because each frame prepares these objects again.

use super::{ClipBox, Shape};
use crate::archive::{self, Archive, Fields};
use crate::math::{Real, Vec3};

const ORIGIN: Vec3<Real> = Vec3::new(Real::ZERO, Real::ZERO, Real::ZERO);
const EMPTY: [Real; 2] = [Real::ZERO; 2];

impl Shape {
    /// A sphere with radius 0, which is not valid.
    pub(crate) const NONE: Self = Self::Sphere {
        center: ORIGIN,
        radius: Real::ZERO,
    };

    /// Tag of the shape in a compiled scene.
    fn tag(&self) -> u8 {
        match self {
            Self::Sphere { .. } => 0,
            Self::Plane { .. } => 1,
            Self::Ellipsoid { .. } => 2,
            Self::Cylinder { .. } => 3,
            Self::Cone { .. } => 4,
            Self::Paraboloid { .. } => 5,
            Self::Sphereflake { .. } => 6,
        }
    }

    /// Returns a placeholder of the kind that a tag stands for. The decoder then reads the fields.
    /// For an unknown tag, returns [`Shape::NONE`].
    fn of_tag(tag: u8) -> Self {
        let (center, origin, radius) = (ORIGIN, ORIGIN, Real::ZERO);
        match tag {
            1 => Self::Plane {
                normal: ORIGIN,
                point: ORIGIN,
                bounds: ClipBox::NONE,
            },
            2 => Self::Ellipsoid {
                center,
                radii: ORIGIN,
            },
            3 => Self::Cylinder {
                origin,
                radius,
                y: None,
            },
            4 => Self::Cone {
                origin,
                radius,
                height: Real::ZERO,
                y: None,
            },
            5 => Self::Paraboloid { origin, y: EMPTY },
            6 => Self::Sphereflake {
                center,
                radius,
                depth: 0,
                ratio: Real::ZERO,
                frame: [ORIGIN; 3],
            },
            _ => Self::NONE,
        }
    }
}

impl Fields for Shape {
    fn visit(&mut self, archive: &mut impl Archive) {
        let mut tag = self.tag();
        tag.visit(archive);
        if tag != self.tag() {
            *self = Self::of_tag(tag);
        }
        match self {
            Self::Sphere { center, radius } => {
                archive::vector(center, archive);
                archive::fixed(radius, archive);
            }
            Self::Plane {
                normal,
                point,
                bounds,
            } => {
                archive::vector(normal, archive);
                archive::vector(point, archive);
                let ClipBox { x, y, z } = bounds;
                for side in [x, y, z] {
                    optional(side, archive);
                }
            }
            Self::Ellipsoid { center, radii } => {
                archive::vector(center, archive);
                archive::vector(radii, archive);
            }
            Self::Cylinder { origin, radius, y } => {
                archive::vector(origin, archive);
                archive::fixed(radius, archive);
                optional(y, archive);
            }
            Self::Cone {
                origin,
                radius,
                height,
                y,
            } => {
                archive::vector(origin, archive);
                archive::fixed(radius, archive);
                archive::fixed(height, archive);
                optional(y, archive);
            }
            Self::Paraboloid { origin, y } => {
                archive::vector(origin, archive);
                interval(y, archive);
            }
            Self::Sphereflake {
                center,
                radius,
                depth,
                ratio,
                frame,
            } => {
                archive::vector(center, archive);
                archive::fixed(radius, archive);
                depth.visit(archive);
                archive::fixed(ratio, archive);
                for axis in frame {
                    archive::vector(axis, archive);
                }
            }
        }
    }
}

fn interval(ends: &mut [Real; 2], archive: &mut impl Archive) {
    for end in ends {
        archive::fixed(end, archive);
    }
}

/// Passes an interval that may be missing to an archive. The first byte is 1 if it is present.
fn optional(ends: &mut Option<[Real; 2]>, archive: &mut impl Archive) {
    let mut is_present = u8::from(ends.is_some());
    is_present.visit(archive);
    *ends = (is_present != 0).then(|| {
        let mut present = ends.unwrap_or(EMPTY);
        interval(&mut present, archive);
        present
    });
}
