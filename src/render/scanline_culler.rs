//! Culling of objects per scanline.
//!
//! The camera rays of a scanline lie in a plane through the eye. This plane may cut the bounding
//! sphere of an object in a circle. The two tangents from the eye to this circle bound the columns
//! in which the object can be visible.

use core::mem;

use fixed::types::I8F56;
use heapless::Vec;

use crate::geometry::BoundingSphere;
use crate::math::{Length, Product, Square, high, square_root};
use crate::prepare::PreparedScene;
use crate::render::camera_rays::CameraRays;
use crate::render::scanline_plane::ScanlinePlane;
use crate::trace::{Candidates, MAX_CANDIDATES};

/// Finder of the objects that the rays of a scanline may hit.
///
/// The culler stores a span of columns for each object that may be visible in the scanline. If more
/// than [`MAX_CANDIDATES`] objects may be visible, the rays of the scanline are tested against all
/// objects of the scene.
#[derive(Clone, Debug, Default)]
pub(crate) struct ScanlineCuller {
    spans: Vec<Span, MAX_CANDIDATES>,
    /// Index into `spans`. All spans from this index on belong to planes.
    first_plane_span: u8,
    /// Index into `spans`. All spans from this index on belong to planes that are parallel to the
    /// scanline.
    first_parallel_span: u8,
    /// Objects whose spans contain the current column.
    active: Candidates,
    /// Next column at which a span begins or ends. At this column, `active` must be updated.
    next_event: u32,
}

/// Columns `from..to` in which an object may be visible.
#[derive(Clone, Copy, Debug)]
struct Span {
    object: u16,
    from: u16,
    to: u16,
}

impl ScanlineCuller {
    /// Computes the spans of line `y`.
    ///
    /// Bounded objects come first in the list of spans, in the order in which secondary rays test
    /// them. If the surfaces of two objects coincide, camera rays and secondary rays therefore hit
    /// the same one of the two objects.
    pub(crate) fn set_row(&mut self, scene: &PreparedScene<'_>, rays: &CameraRays, y: u32) {
        self.spans.clear();
        self.next_event = 0;
        self.active.is_miss = false;
        let plane = ScanlinePlane::new(&scene.settings.camera, rays, y);
        let all_columns = [0, plane.width];
        let mut fits = true;
        for sphere in scene.bounded {
            if let Some(columns) = visible_columns(&sphere.bounding_sphere(), &plane) {
                fits &= self.add(sphere.object, columns);
            }
        }
        self.first_plane_span = self.spans.len() as u8;
        self.first_parallel_span = self.spans.len() as u8;
        for &object in scene.unbounded {
            let (is_plane, is_parallel) = match scene.object(object).shape.as_plane() {
                Some(it) if !plane.may_intersect(it) => continue,
                Some(it) => (true, plane.is_parallel(it)),
                None => (false, false),
            };
            fits &= self.add(object, all_columns);
            let count = self.spans.len() as u8;
            if !is_plane {
                self.first_plane_span = count;
            }
            if !is_parallel {
                self.first_parallel_span = count;
            }
        }
        self.active.is_complete = fits;
    }

    /// Adds a span unless the span is empty. Returns false if the list of spans is full.
    fn add(&mut self, object: u16, [from, to]: [u16; 2]) -> bool {
        from >= to || self.spans.push(Span { object, from, to }).is_ok()
    }

    /// Returns the objects that the ray of column `x` may hit. Within a scanline, `x` must not
    /// decrease from one call to the next.
    pub(crate) fn at_column(&mut self, x: u32) -> &mut Candidates {
        if x >= self.next_event {
            self.advance(x);
        }
        &mut self.active
    }

    /// Returns true if the most recent camera ray hit nothing, and forgets this.
    pub(crate) fn take_miss(&mut self) -> bool {
        mem::take(&mut self.active.is_miss)
    }

    /// Updates `active` and `next_event` for column `x`.
    ///
    /// This function is rarely called: only at columns where a span begins or ends. It is therefore
    /// not inlined.
    #[inline(never)]
    fn advance(&mut self, x: u32) {
        let active = &mut self.active;
        active.objects.clear();
        active.are_planes = active.is_complete;
        active.is_coplanar = active.is_complete;
        active.cached_hit = None;
        self.next_event = u32::MAX;
        for (span, index) in self.spans.iter().zip(0..) {
            let (from, to) = (u32::from(span.from), u32::from(span.to));
            if x < from {
                self.next_event = self.next_event.min(from);
            } else if x < to {
                self.next_event = self.next_event.min(to);
                active.are_planes &= index >= self.first_plane_span;
                active.is_coplanar &=
                    active.objects.is_empty() && index >= self.first_parallel_span;
                // The push cannot fail, because `objects` has the same capacity as `spans`.
                let _ = active.objects.push(span.object);
            }
        }
    }
}

/// Returns the columns in which a bounding sphere may be visible, or `None` if there are none.
///
/// Let `r` be the radius of the sphere. The center of the sphere is at distance `u` to the right of
/// the eye and at distance `e` in front of the eye. Its distance from the plane of the scanline's
/// rays is `a`. This plane cuts the sphere in a circle of radius `P = sqrt((r - a) (r + a))`. Let
/// `L² = u² + e² + a² - r²`. The tangents from the eye to the circle have the slopes `(u e ± P L) /
/// (e² - P²)`. Cancellation can lose precision only in the difference of `e` and `P`.
fn visible_columns(bound: &BoundingSphere, plane: &ScanlinePlane) -> Option<[u16; 2]> {
    /// Upper bound of the sum of all rounding errors. It is added to the radius.
    const MARGIN: Length = Length::lit("0.00001");
    let radius: Length = bound.radius + (bound.radius >> 10) + MARGIN;
    let center = bound.center - plane.eye;
    // The component along an axis has Q58. Its upper word has Q26 and is shifted to Q28.
    let along = |axis| Length::from_bits(high(center.along(axis).to_bits()) << 2);
    let offset = along(plane.normal);
    if offset.abs() > radius {
        return None;
    }
    let forward = along(plane.forward);
    let circle_squared = (radius - offset).product(radius + offset);
    let circle = Length::from_bits(square_root(circle_squared.to_bits() as u64) as i32);
    if forward < -circle {
        return None;
    }
    let tangent_squared = center.squared() - radius.square();
    if forward <= circle || tangent_squared <= 0 {
        return Some([0, plane.width]);
    }
    let tangent = Length::from_bits(square_root(tangent_squared.to_bits() as u64) as i32);
    let middle = along(plane.right).product(forward);
    let half_width = circle.product(tangent);
    let divisor = (forward - circle).product(forward.saturating_add(circle));
    let end = |n: I8F56| plane.column(n.to_bits(), divisor.to_bits() as u64);
    // The range is widened by one column on each side. `to` is the column after the last column of
    // the range.
    let from = end(middle - half_width).saturating_sub(1);
    let to = end(middle + half_width).saturating_add(2);
    Some([from.min(plane.width), to.min(plane.width)])
}
