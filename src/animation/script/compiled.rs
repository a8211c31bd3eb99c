//! The script of an animation in a compiled scene.
//!
//! ```text
//! duration: i64  looping: u8  shapes: u16
//! for each shape: object: u16, fields of the authored shape
//! for each track: target: u8, u16  smooth: u8  keyframes: u16
//!                 for each keyframe: time, x, y, z: i64
//! ```

use super::Script;
use super::shape_list::ShapeList;
use super::track_list::TrackList;
use crate::archive::{self, Archive, Fields, Reader};
use crate::codec::Section;
use crate::math::Real;

#[derive(Default)]
struct Head {
    duration: Real,
    looping: u8,
    shapes: u16,
}

impl Fields for Head {
    fn visit(&mut self, archive: &mut impl Archive) {
        archive::fixed(&mut self.duration, archive);
        self.looping.visit(archive);
        self.shapes.visit(archive);
    }
}

impl<'a> Script<'a> {
    /// Finds the shapes and the tracks in the bytes of a compiled script. Returns `None` if the
    /// tracks do not end where the bytes end, or if a track has an unknown target.
    pub(in crate::animation) fn decode(bytes: &'a [u8]) -> Option<Self> {
        let mut reader = Reader::new(bytes);
        let mut head = Head::default();
        head.visit(&mut reader);
        let shapes = ShapeList::read(head.shapes, &mut reader);
        let tracks = TrackList::Compiled(reader.bytes);
        let mut rest = tracks;
        while rest.next(None).is_some() {}
        (!reader.short && rest.is_empty()).then_some(Self {
            duration: head.duration,
            looping: head.looping != 0,
            shapes,
            tracks,
        })
    }

    /// Returns the numbers of the animated objects.
    fn objects(&self) -> impl Iterator<Item = u16> {
        let objects = || self.tracks().map(|track| track.target.object());
        objects().enumerate().filter_map(move |(index, object)| {
            let is_first = objects().take(index).all(|earlier| earlier != object);
            object.filter(|_| is_first)
        })
    }
}

impl Section for Script<'_> {
    fn write(&self, archive: &mut impl Archive) {
        let mut head = Head {
            duration: self.duration,
            looping: self.looping.into(),
            shapes: self.objects().count() as u16,
        };
        head.visit(archive);
        for mut object in self.objects() {
            if let Some(mut shape) = self.shape(object) {
                object.visit(archive);
                shape.visit(archive);
            }
        }
        self.tracks().for_each(|track| track.write(archive));
    }
}
