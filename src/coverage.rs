//! Which objects the eye rays of a line may meet, and between which columns.
//!
//! Through each line of pixels goes a plane of eye rays. It cuts a bounding
//! sphere in a circle, and the tangents from the eye to that circle are the
//! ends of the columns from which the sphere may be seen.

use heapless::Vec;

use crate::camera::{Row, View};
use crate::num::{Length, Product, Square, square_root};
use crate::prepared::PreparedScene;
use crate::shape::{Bound, Shape};

/// More objects than these in one line are not told apart: all rays of the
/// line are then traced against all objects.
const MOST: usize = 64;

/// The objects of a line.
#[derive(Clone, Debug, Default)]
pub(crate) struct Coverage {
    spans: Vec<Span, MOST>,
    /// The numbers of the objects at a column.
    here: Vec<u16, MOST>,
    /// From which column on there may be others.
    change: u32,
    is_complete: bool,
}

/// Columns, the last of them not included.
#[derive(Clone, Copy, Debug)]
struct Span {
    object: u16,
    from: u16,
    to: u16,
}

impl Coverage {
    /// Finds the objects of line `y`: the finite ones first, as all other rays look at
    /// them, so that of two surfaces in one place the same is seen.
    pub(crate) fn look(&mut self, scene: &PreparedScene<'_>, view: &View, y: u32) {
        self.spans.clear();
        self.change = 0;
        let row = view.row(y);
        let whole = [0, row.width];
        let mut fits = true;
        for (bound, around) in scene.sights.eye.iter().zip(scene.finite) {
            if let Some(columns) = columns(bound, &row) {
                fits &= self.add(around.object, columns);
            }
        }
        for &object in scene.endless {
            let shape = scene.objects.get(usize::from(object)).map(|it| &it.shape);
            if let Some(Shape::Plane(plane)) = shape
                && !row.may_meet(plane)
            {
                continue;
            }
            fits &= self.add(object, whole);
        }
        self.is_complete = fits;
    }

    fn add(&mut self, object: u16, [from, to]: [u16; 2]) -> bool {
        from >= to || self.spans.push(Span { object, from, to }).is_ok()
    }

    /// The numbers of the objects that the ray through column `x` may meet,
    /// columns being asked for in rising order; `None` if that may be any.
    #[inline]
    pub(crate) fn at(&mut self, x: u32) -> Option<&[u16]> {
        if x >= self.change {
            self.advance(x);
        }
        self.is_complete.then_some(&self.here)
    }

    #[inline(never)]
    fn advance(&mut self, x: u32) {
        self.here.clear();
        self.change = u32::MAX;
        for span in &self.spans {
            let (from, to) = (u32::from(span.from), u32::from(span.to));
            if x < from {
                self.change = self.change.min(from);
            } else if x < to {
                self.change = self.change.min(to);
                // There is room for all of them.
                let _ = self.here.push(span.object);
            }
        }
    }
}

/// The columns of a line from which a sphere, in the camera's frame, may be
/// seen; `None` if there are none.
///
/// Let the line be Y up the picture, at the distance of 1, and the center
/// (u, v, w). The line's plane passes the center by `a / s` with `a = v - Y w`
/// and `s² = 1 + Y²`, and `e / s` with `e = w + Y v` is how far ahead it is in
/// that plane. With `P² = (s r - a) (s r + a)` and `L² = u² + v² + w² - r²` the tangents
/// are at `X = s² (u e ± P L) / (e² - P²)`: no difference but that of e and P
/// can cancel.
fn columns(bound: &Bound, row: &Row) -> Option<[u16; 2]> {
    let whole = Some([0, row.width]);
    let Bound { center, radius } = *bound;
    let radius_squared = radius.square();
    // Q28 and Q26 * Q28 -> Q54, to Q24; below 128.
    let across = |p: Length, q: Length| {
        (i64::from(p.to_bits()) >> 4) + (row.height.product(q.to_bits()) >> 30)
    };
    let aside = across(center.y, -center.z);
    let ahead = across(center.z, center.y);
    // Q24 * Q28 -> Q24; the square Q48.
    let radius = row.stretch.product(radius.to_bits()) >> 28;
    let square = (radius - aside) * (radius + aside);
    if square < 0 {
        return None;
    }
    let reach = i64::from(square_root(square as u64)) + 1;
    if ahead < -reach {
        return None;
    }
    let tangent_squared = center.squared() - radius_squared;
    if ahead <= reach || tangent_squared <= 0 {
        return whole;
    }
    let tangent = i64::from(square_root(tangent_squared.to_bits() as u64) >> 4);
    let middle = (i64::from(center.x.to_bits()) >> 4) * ahead;
    let divisor = (ahead - reach) * (ahead + reach);
    let end = |numerator: i64| row.column(numerator, divisor as u64);
    let from = end(middle - reach * tangent).saturating_sub(1);
    let to = end(middle + reach * tangent).saturating_add(2);
    Some([from.min(row.width), to.min(row.width)])
}
