//! What can be wrong with a scene.

use core::fmt;

use crate::math::{Decimal, Real};

/// Why a scene could not be prepared: which item, which of its fields, what is wrong.
///
/// Fields are named as in scene files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SceneError {
    /// What is wrong belongs to this.
    pub item: SceneItem,
    /// The field of the item, for example `"radius"`.
    pub field: &'static str,
    /// What is wrong with it.
    pub problem: SceneProblem,
}

/// A list of a buffer has no more room.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CapacityError {
    list: &'static str,
    capacity: u16,
}

impl CapacityError {
    pub(crate) fn new(list: &'static str, capacity: usize) -> Self {
        Self {
            list,
            capacity: u16::try_from(capacity).unwrap_or(u16::MAX),
        }
    }
}

impl From<CapacityError> for SceneError {
    fn from(CapacityError { list, capacity }: CapacityError) -> Self {
        Self {
            item: SceneItem::Scene,
            field: list,
            problem: SceneProblem::TooMany { capacity },
        }
    }
}

impl From<CapacityError> for DecodeError {
    fn from(CapacityError { list, capacity }: CapacityError) -> Self {
        Self::TooMany { list, capacity }
    }
}

/// A part of a scene; lists are numbered from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SceneItem {
    /// The scene's own settings.
    Scene,
    /// The camera.
    Camera,
    /// A light.
    Light(u16),
    /// A material.
    Material(u16),
    /// An object.
    Object(u16),
}

/// What is wrong with a field.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum SceneProblem {
    /// A number is outside its range, both ends of which are allowed.
    OutOfRange {
        /// The least value.
        least: Real,
        /// The greatest value.
        most: Real,
    },
    /// A vector that needs a direction is (nearly) zero.
    NoDirection,
    /// The camera looks at its own eye.
    NoView,
    /// `up` points along the view.
    AlongView,
    /// Too far from a scene that is already prepared: it must be prepared anew.
    OutOfReach,
    /// The low end of an interval is not below its high end.
    EmptyInterval,
    /// The two axes of a checkerboard are the same.
    SameAxis,
    /// The rows of a frame are not unit vectors at right angles, right-handed.
    NotOrthonormal,
    /// No material has this number.
    NoSuchMaterial(u16),
    /// The list is longer than the buffer, which holds so many.
    TooMany {
        /// What the buffer holds.
        capacity: u16,
    },
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {} {}", self.item, self.field, self.problem)
    }
}

impl fmt::Display for SceneItem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Scene => f.write_str("scene"),
            Self::Camera => f.write_str("camera"),
            Self::Light(index) => write!(f, "light {index}"),
            Self::Material(index) => write!(f, "material {index}"),
            Self::Object(index) => write!(f, "object {index}"),
        }
    }
}

impl fmt::Display for SceneProblem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OutOfRange { least, most } => {
                write!(f, "must be from {} to {}", Decimal(*least), Decimal(*most))
            }
            Self::NoDirection => f.write_str("must not be zero"),
            Self::NoView => f.write_str("must be another point than the eye"),
            Self::AlongView => f.write_str("must not point along the view"),
            Self::OutOfReach => f.write_str(
                "is too far from the scene as it is prepared; prepare it anew with this camera",
            ),
            Self::EmptyInterval => f.write_str("must run from a lower to a higher value"),
            Self::SameAxis => f.write_str("must name two different axes"),
            Self::NotOrthonormal => {
                f.write_str("must be three unit vectors at right angles, u × v = w")
            }
            Self::NoSuchMaterial(index) => write!(f, "names material {index}, which is not there"),
            Self::TooMany { capacity } => {
                write!(f, "are more than the {capacity} there is room for")
            }
        }
    }
}

impl core::error::Error for SceneError {}

/// Why compiled bytes are not a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum DecodeError {
    /// The bytes do not begin as a compiled scene does.
    NotAScene,
    /// Compiled by another version of the format.
    Version(u8),
    /// Too few bytes for a header; or the checksum agrees, but there are fewer or more bytes
    /// than the lists take.
    Length,
    /// The checksum disagrees: the bytes were damaged, or some are missing.
    Checksum,
    /// Checksum and length agree, but a value is not one a scene can have.
    Invalid(SceneItem),
    /// A list is longer than the buffer, which holds so many.
    TooMany {
        /// `"objects"`, `"lights"` or `"materials"`.
        list: &'static str,
        /// What the buffer holds.
        capacity: u16,
    },
}

impl fmt::Display for DecodeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotAScene => f.write_str("not a compiled scene"),
            Self::Version(version) => {
                write!(f, "compiled for another format, {version}: compile it anew")
            }
            Self::Length => f.write_str("cut short or too long"),
            Self::Checksum => f.write_str("damaged or cut short: wrong checksum"),
            Self::Invalid(item) => write!(f, "{item} has an impossible value"),
            // Not by way of `SceneError`, which would bring the printing of
            // numbers with fractions into firmware.
            Self::TooMany { list, capacity } => {
                write!(f, "more {list} than the {capacity} there is room for")
            }
        }
    }
}

impl core::error::Error for DecodeError {}
