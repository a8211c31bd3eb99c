//! Errors of preparing and decoding a scene.

use core::fmt;

use crate::math::{Decimal, Real};

/// Reason why a scene cannot be prepared: the item, its field and the problem.
///
/// ```
/// use whitted::scene::{SceneItem, SceneProblem};
/// use whitted::{Camera, Real, Scene, SceneBuffer, Vec3};
///
/// let camera = Camera::new(Vec3::lit("0", "2", "8"), Vec3::lit("0", "1", "0"), Real::ZERO);
/// let error = SceneBuffer::<1, 1, 1>::new().prepare(&Scene::new(camera)).unwrap_err();
/// assert_eq!(error.item, SceneItem::Camera);
/// assert!(matches!(error.problem, SceneProblem::OutOfRange { .. }));
/// assert_eq!(error.to_string(), "camera: fovy_deg must be from 1 to 170");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SceneError {
    /// Item that cannot be prepared.
    pub item: SceneItem,
    /// Name of the item's field as in scene files, for example `"radius"`.
    pub field: &'static str,
    /// Problem of the field.
    pub problem: SceneProblem,
}

/// A list of a buffer is full.
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

/// Item of a scene. Lights, materials and objects are numbered from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SceneItem {
    /// The settings and lists of [`Scene`](crate::Scene).
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

/// Problem of a scene's field.
///
/// [`Display`](fmt::Display) writes a predicate that follows the name of the field, for example
/// "must be from 1 to 170".
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum SceneProblem {
    /// The number is outside its range. Both ends of the range are allowed.
    OutOfRange {
        /// Least allowed value.
        least: Real,
        /// Greatest allowed value.
        most: Real,
    },
    /// The vector is too short to give a direction.
    NoDirection,
    /// The camera's `look_at` is its `eye`.
    NoView,
    /// The camera's `up` is parallel to its line of sight.
    AlongView,
    /// The camera's eye is outside the range that the scene was prepared for.
    OutOfReach,
    /// The low end of the interval is not below its high end.
    EmptyInterval,
    /// Both axes of the checkerboard are the same.
    SameAxis,
    /// The vectors of the frame are not a right-handed orthonormal basis.
    NotOrthonormal,
    /// The number of the material is not below the number of materials.
    NoSuchMaterial {
        /// Number of the missing material.
        index: u16,
        /// Number of materials of the scene.
        count: u16,
    },
    /// The list is longer than the capacity of the buffer.
    TooMany {
        /// Capacity of the buffer.
        capacity: u16,
    },
    /// The crate was built without the named Cargo feature, which the value needs.
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

/// Reason why bytes cannot be decoded as a compiled scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum DecodeError {
    /// The bytes do not start with the magic number of a compiled scene.
    NotAScene,
    /// The scene was compiled for another version of the format.
    Version {
        /// Version of the scene.
        found: u8,
        /// Version that this crate decodes.
        expected: u8,
    },
    /// There are fewer bytes than a header takes, or the checksum is right but the lists take
    /// fewer or more bytes than there are.
    Length,
    /// The checksum is wrong: the bytes are damaged or truncated.
    Checksum,
    /// Checksum and length are right, but a value of the item is invalid.
    Invalid(SceneItem),
    /// A list is longer than the capacity of the buffer.
    TooMany {
        /// `"objects"`, `"lights"` or `"materials"`.
        list: &'static str,
        /// Capacity of the buffer.
        capacity: u16,
    },
    /// The crate was built without the named Cargo feature, which the scene needs.
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
            // `SceneError` would format this too, but links the formatting of fixed-point numbers
            // into firmware.
            Self::TooMany { list, capacity } => {
                write!(f, "too many {list}: the buffer holds {capacity}")
            }
            Self::MissingFeature(feature) => needs_feature(f, feature),
        }
    }
}

impl core::error::Error for DecodeError {}
