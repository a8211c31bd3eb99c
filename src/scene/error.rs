//! Errors of preparing and decoding a scene.

use core::fmt;

use crate::math::{Decimal, Real};

/// Reason why a scene cannot be prepared. The error names the item, its field and the problem.
///
/// ```
/// use whitted::scene::{SceneItem, SceneProblem};
/// use whitted::{Camera, Real, Scene, SceneBuffer, vec3};
///
/// let camera = Camera::new(vec3!(0, 2, 8), vec3!(0, 1, 0), Real::ZERO);
/// let error = SceneBuffer::<1, 1, 1>::new().prepare(&Scene::new(camera)).unwrap_err();
/// assert_eq!(error.item, SceneItem::Camera);
/// assert!(matches!(error.problem, SceneProblem::OutOfRange { .. }));
/// assert_eq!(error.to_string(), "camera: fovy_deg must be from 1 to 170");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SceneError {
    /// The item that cannot be prepared.
    pub item: SceneItem,
    /// Name of the field that has the problem, as in scene files, for example `"radius"`.
    pub field: &'static str,
    /// The problem of the field.
    pub problem: SceneProblem,
}

/// Error of a push to a list of a buffer that is already full.
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

/// An item of a scene. Lights, materials and objects are numbered from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SceneItem {
    /// The scene itself: its settings and lists, as in [`Scene`](crate::Scene).
    Scene,
    /// The camera.
    Camera,
    /// The light with this number.
    Light(u16),
    /// The material with this number.
    Material(u16),
    /// The object with this number.
    Object(u16),
}

/// Problem of a field of a scene.
///
/// [`Display`](fmt::Display) writes the problem as the end of a sentence that starts with the
/// name of the field, for example "must be from 1 to 170".
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum SceneProblem {
    /// The number is outside the allowed range. The range includes both of its ends.
    OutOfRange {
        /// Smallest allowed number.
        least: Real,
        /// Greatest allowed number.
        most: Real,
    },
    /// The vector is so short that it has no direction.
    NoDirection,
    /// The camera's `look_at` equals its `eye`, so there is no view direction.
    NoView,
    /// The camera's `up` is parallel to its line of sight.
    AlongView,
    /// The camera's eye is outside the range for which the scene was prepared.
    OutOfReach,
    /// The interval is empty: its low end is not below its high end.
    EmptyInterval,
    /// The two axes of the checkerboard are the same axis.
    SameAxis,
    /// The three vectors of the `frame` are not a right-handed orthonormal basis.
    NotOrthonormal,
    /// The scene has no material with this number. Numbers start at 0.
    NoSuchMaterial {
        /// Number of the missing material.
        index: u16,
        /// Number of materials in the scene.
        count: u16,
    },
    /// The list is longer than the capacity of the buffer.
    TooMany {
        /// Capacity of the buffer for this list.
        capacity: u16,
    },
    /// The value needs this Cargo feature, which is disabled in this build.
    MissingFeature(&'static str),
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
            Self::NoView => f.write_str("must differ from `eye`"),
            Self::AlongView => f.write_str("must not be parallel to the line of sight"),
            Self::OutOfReach => {
                f.write_str("is outside the prepared range; call `prepare` with this camera")
            }
            Self::EmptyInterval => f.write_str("must run from a lower to a higher value"),
            Self::SameAxis => f.write_str("must name two different axes"),
            Self::NotOrthonormal => {
                f.write_str("must be three unit vectors at right angles, u × v = w")
            }
            Self::NoSuchMaterial { index, count } => write!(
                f,
                "refers to material {index}, but the number of materials is {count}"
            ),
            Self::TooMany { capacity } => {
                write!(f, "exceed the buffer's capacity of {capacity}")
            }
            Self::MissingFeature(feature) => needs_feature(f, feature),
        }
    }
}

fn needs_feature(f: &mut fmt::Formatter<'_>, feature: &str) -> fmt::Result {
    write!(f, "needs the Cargo feature `{feature}`")
}

impl core::error::Error for SceneError {}

/// Reason why bytes cannot be decoded to a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum DecodeError {
    /// The bytes do not start with the magic number of a compiled scene.
    NotAScene,
    /// The scene was compiled for a different version of the format.
    Version {
        /// Version of the compiled scene.
        found: u8,
        /// Version that this build of the crate decodes.
        expected: u8,
    },
    /// The number of bytes is wrong. Either there are fewer bytes than a header has, or the lists
    /// of the scene do not end where the checksum begins, although the checksum is right.
    Length,
    /// The checksum is wrong: the bytes are damaged or truncated.
    Checksum,
    /// The checksum and the length are right, but a value of the item is invalid.
    Invalid(SceneItem),
    /// The checksum is right, but the animation has an invalid value.
    InvalidAnimation,
    /// A list of the scene is longer than the capacity of the buffer.
    TooMany {
        /// Name of the list: `"objects"`, `"lights"` or `"materials"`.
        list: &'static str,
        /// Capacity of the buffer for this list.
        capacity: u16,
    },
    /// The scene needs this Cargo feature, which is disabled in this build.
    MissingFeature(&'static str),
}

impl fmt::Display for DecodeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotAScene => f.write_str("not a compiled scene"),
            Self::Version { found, expected } => write!(
                f,
                "unsupported format version {found}, expected {expected}: recompile the scene"
            ),
            Self::Length => f.write_str("wrong length: the scene is truncated or too long"),
            Self::Checksum => f.write_str("wrong checksum: the scene is damaged or truncated"),
            Self::Invalid(item) => write!(f, "{item} has an invalid value"),
            Self::InvalidAnimation => f.write_str("the animation has an invalid value"),
            // This message does not use `SceneError`, because `SceneError` would link the
            // formatting of fixed-point numbers into firmware.
            Self::TooMany { list, capacity } => {
                write!(f, "too many {list}: the buffer holds {capacity}")
            }
            Self::MissingFeature(feature) => needs_feature(f, feature),
        }
    }
}

impl core::error::Error for DecodeError {}
