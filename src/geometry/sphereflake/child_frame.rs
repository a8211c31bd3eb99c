//! The directions and frames of the twelve children of a sphere.
//!
//! The directions point to the twelve vertices of a cuboctahedron. Six vertices are on the equator
//! and three are above it. The other three are below the equator, opposite the upper ones.

use crate::math::{Product, Unit, Vec3, high};

/// The rotation from the parent's axis w to the direction `a` of a child, by the smallest angle.
///
/// The axes of the parent are `u`, `v` and `w`. The rotation takes `u` to
/// `u - a.u / (1 + a.w) (w + a)`, and the same formula with `v` gives the new `v`. The matrix of
/// the rotation is symmetric, except for the last row and the last column, which are `a` and `-a`.
#[derive(Clone, Copy)]
struct ChildFrame {
    axis: Vec3<Unit>,
    /// Three elements of the rotation matrix, for the direction a of the child: `u` is
    /// `1 - a.u² / (1 + a.w)`, `v` is `1 - a.v² / (1 + a.w)`, and `uv` is
    /// `-a.u a.v / (1 + a.w)`.
    u: Unit,
    v: Unit,
    uv: Unit,
}

/// sqrt(3/4), the sine of 60°. This is the angle between two neighbors on the equator.
pub(super) const EQUATOR: Unit = Unit::lit("0.866025403784438646763723");
/// sqrt(1/12), half the cosine of the elevation of the upper children, which is atan(sqrt 2).
pub(super) const HALF_COSINE: Unit = Unit::lit("0.288675134594812882254575");
/// sqrt(2/3), the sine of the elevation of the upper children.
pub(super) const ELEVATION: Unit = Unit::lit("0.816496580927726032732428");

/// Frames of the children, indexed by the number of the child, 1 to 12. The remaining entries of
/// the array are not used.
static FRAMES: [ChildFrame; 16] = {
    const fn unit(bits: i64) -> Unit {
        Unit::from_bits(bits as i32)
    }
    const fn frame(x: i64, y: i64, z: i64) -> ChildFrame {
        // Q60 divided by Q30 gives Q30, which is rounded.
        const fn quotient(product: i64, z: i64) -> i64 {
            let whole = (1 << 30) + z;
            (product + product.signum() * whole / 2) / whole
        }
        ChildFrame {
            axis: Vec3::new(unit(x), unit(y), unit(z)),
            u: unit(ONE - quotient(x * x, z)),
            v: unit(ONE - quotient(y * y, z)),
            uv: unit(-quotient(x * y, z)),
        }
    }
    const ONE: i64 = 1 << 30;
    const S: i64 = EQUATOR.to_bits() as i64;
    const H: i64 = HALF_COSINE.to_bits() as i64;
    const E: i64 = ELEVATION.to_bits() as i64;
    let none = frame(0, 0, ONE);
    [
        none,
        frame(ONE, 0, 0),
        frame(ONE / 2, S, 0),
        frame(-ONE / 2, S, 0),
        frame(ONE / 2, H, E),
        frame(-ONE / 2, H, E),
        frame(0, -2 * H, E),
        frame(-ONE, 0, 0),
        frame(-ONE / 2, -S, 0),
        frame(ONE / 2, -S, 0),
        frame(-ONE / 2, -H, -E),
        frame(ONE / 2, -H, -E),
        frame(0, 2 * H, -E),
        none,
        none,
        none,
    ]
};

fn frame(child: u32) -> &'static ChildFrame {
    // In a path, the number of a child has four bits. The mask makes this known to the compiler,
    // which then omits the bounds check.
    &FRAMES[child as usize & 15]
}

/// Returns the unit vector from a sphere to its child.
pub(super) fn axis(child: u32) -> Vec3<Unit> {
    frame(child).axis
}

/// Returns the sum of three products. One factor of each product has Q30. The sum has the format of
/// the other factors. Its lowest two bits are zero.
fn sum([x, y, z]: [(i32, Unit); 3]) -> i32 {
    let product = |(c, factor): (i32, Unit)| c.product(factor.to_bits());
    high(product(x) + product(y) + product(z)) << 2
}

/// Converts a vector from the parent's frame to the child's frame. The vector may be in any unit.
pub(super) fn to_child(Vec3 { x, y, z }: Vec3<i32>, child: u32) -> Vec3<i32> {
    let ChildFrame { axis, u, v, uv } = *frame(child);
    Vec3::new(
        sum([(x, u), (y, uv), (-z, axis.x)]),
        sum([(x, uv), (y, v), (-z, axis.y)]),
        sum([(x, axis.x), (y, axis.y), (z, axis.z)]),
    )
}

/// Converts a vector from the child's frame to the parent's frame. The vector may be in any unit.
#[inline]
pub(super) fn to_parent(Vec3 { x, y, z }: Vec3<i32>, child: u32) -> Vec3<i32> {
    let ChildFrame { axis, u, v, uv } = *frame(child);
    Vec3::new(
        sum([(x, u), (y, uv), (z, axis.x)]),
        sum([(x, uv), (y, v), (z, axis.y)]),
        sum([(-x, axis.x), (-y, axis.y), (z, axis.z)]),
    )
}
