use crate::archive::{Fields, Reader};
use crate::scene::{Object, Shape};

/// The authored shapes of objects.
#[derive(Clone, Copy)]
pub(super) enum ShapeList<'a> {
    Authored(&'a [Object]),
    /// Each entry has the number of an object and its shape.
    Compiled {
        count: u16,
        bytes: &'a [u8],
    },
}

impl<'a> ShapeList<'a> {
    /// Returns the list of `count` shapes that a reader is at, and moves the reader past its end.
    pub(super) fn read(count: u16, reader: &mut Reader<'a>) -> Self {
        let bytes = reader.bytes;
        for _ in 0..count {
            read_shape(reader);
        }
        Self::Compiled { count, bytes }
    }

    pub(super) fn get(&self, object: u16) -> Option<Shape> {
        match *self {
            Self::Authored(objects) => objects.get(usize::from(object)).map(|it| it.shape),
            Self::Compiled { count, bytes } => {
                let mut reader = Reader::new(bytes);
                let mut shapes = (0..count).map(|_| read_shape(&mut reader));
                shapes.find_map(|(index, shape)| (index == object).then_some(shape))
            }
        }
    }
}

fn read_shape(reader: &mut Reader<'_>) -> (u16, Shape) {
    let (mut object, mut shape) = (0_u16, Shape::NONE);
    object.visit(reader);
    shape.visit(reader);
    (object, shape)
}
