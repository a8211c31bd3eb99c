use crate::animation::curve::Curve;
use crate::animation::keys::Keys;
use crate::animation::{Interpolation, Target, Track};
use crate::archive::{Archive, Fields, Reader};
use crate::math::Real;

/// The tracks that are still to be read.
#[derive(Clone, Copy)]
pub(super) enum TrackList<'a> {
    Authored(&'a [Track<'a>]),
    Compiled(&'a [u8]),
}

/// A track: the curve of a value, and the property that has this value.
pub(in crate::animation) struct ScriptTrack<'a> {
    pub(in crate::animation) target: Target,
    pub(in crate::animation) curve: Curve<'a>,
}

impl<'a> TrackList<'a> {
    /// Reads the next track. Returns `None` at the end, or at a compiled track that is not valid.
    /// `period` is the duration of a repeating animation.
    pub(super) fn next(&mut self, period: Option<Real>) -> Option<ScriptTrack<'a>> {
        let (target, keys, interpolation) = match self {
            Self::Authored(tracks) => {
                let (track, rest) = tracks.split_first()?;
                *tracks = rest;
                (
                    track.target,
                    Keys::Authored(track.keys),
                    track.interpolation,
                )
            }
            Self::Compiled(bytes) => {
                let mut reader = Reader::new(bytes);
                let mut head = TrackHead::default();
                head.visit(&mut reader);
                let target = Target::of_code(head.kind, head.index)?;
                let keys = Keys::take(&mut reader.bytes, head.keys)?;
                let interpolation = match head.is_smooth {
                    0 => Interpolation::Linear,
                    _ => Interpolation::Smooth,
                };
                if reader.short {
                    return None;
                }
                *bytes = reader.bytes;
                (target, keys, interpolation)
            }
        };
        let curve = Curve {
            keys,
            interpolation,
            period,
        };
        Some(ScriptTrack { target, curve })
    }

    pub(super) fn is_empty(&self) -> bool {
        match self {
            Self::Authored(tracks) => tracks.is_empty(),
            Self::Compiled(bytes) => bytes.is_empty(),
        }
    }
}

/// The start of a compiled track. The keyframes follow.
#[derive(Default)]
struct TrackHead {
    kind: u8,
    index: u16,
    is_smooth: u8,
    keys: u16,
}

impl Fields for TrackHead {
    fn visit(&mut self, archive: &mut impl Archive) {
        self.kind.visit(archive);
        self.index.visit(archive);
        self.is_smooth.visit(archive);
        self.keys.visit(archive);
    }
}

impl ScriptTrack<'_> {
    /// Writes the track to a compiled scene.
    pub(super) fn write(&self, archive: &mut impl Archive) {
        let Curve {
            keys,
            interpolation,
            ..
        } = self.curve;
        let (kind, index) = self.target.code();
        let mut head = TrackHead {
            kind,
            index,
            is_smooth: (interpolation == Interpolation::Smooth).into(),
            keys: keys.len() as u16,
        };
        head.visit(archive);
        keys.iter().for_each(|mut key| key.visit(archive));
    }
}
