//! The twelve directions of a sphere's children, those of a cuboctahedron: six
//! around the equator, three above and their opposites below.

use crate::math::{Product, Unit, Vec3, high};

/// The smallest rotation that turns a parent's w to a child's direction a. It
/// takes u to `u - a.u / (1 + a.w) (w + a)`, v likewise: symmetric but for its
/// last row and column, which are a and its opposite.
#[derive(Clone, Copy)]
struct Direction {
    axis: Vec3<Unit>,
    /// `1 - a.u² / (1 + a.w)`, `1 - a.v² / (1 + a.w)`, `-a.u a.v / (1 + a.w)`.
    u: Unit,
    v: Unit,
    uv: Unit,
}

/// sqrt(3/4).
pub(super) const EQUATOR: Unit = Unit::lit("0.866025403784438646763723");
/// sqrt(1/12); twice that is the cosine of the elevation, atan(sqrt 2).
pub(super) const ASIDE: Unit = Unit::lit("0.288675134594812882254575");
/// sqrt(2/3), the sine of the elevation.
pub(super) const ELEVATION: Unit = Unit::lit("0.816496580927726032732428");

/// By the number of the child; 0 and those above 12 are of none.
static DIRECTIONS: [Direction; 16] = {
    const fn unit(bits: i64) -> Unit {
        Unit::from_bits(bits as i32)
    }
    const fn direction(x: i64, y: i64, z: i64) -> Direction {
        // Q60 / Q30 -> Q30, rounded
        const fn quotient(product: i64, z: i64) -> i64 {
            let whole = (1 << 30) + z;
            (product + product.signum() * whole / 2) / whole
        }
        Direction {
            axis: Vec3::new(unit(x), unit(y), unit(z)),
            u: unit(ONE - quotient(x * x, z)),
            v: unit(ONE - quotient(y * y, z)),
            uv: unit(-quotient(x * y, z)),
        }
    }
    const ONE: i64 = 1 << 30;
    const S: i64 = EQUATOR.to_bits() as i64;
    const H: i64 = ASIDE.to_bits() as i64;
    const E: i64 = ELEVATION.to_bits() as i64;
    let none = direction(0, 0, ONE);
    [
        none,
        direction(ONE, 0, 0),
        direction(ONE / 2, S, 0),
        direction(-ONE / 2, S, 0),
        direction(ONE / 2, H, E),
        direction(-ONE / 2, H, E),
        direction(0, -2 * H, E),
        direction(-ONE, 0, 0),
        direction(-ONE / 2, -S, 0),
        direction(ONE / 2, -S, 0),
        direction(-ONE / 2, -H, -E),
        direction(ONE / 2, -H, -E),
        direction(0, 2 * H, -E),
        none,
        none,
        none,
    ]
};

#[inline(always)]
fn direction(child: u32) -> &'static Direction {
    // A path has four bits for each; the mask tells the compiler so.
    &DIRECTIONS[child as usize & 15]
}

/// The direction of a child.
#[inline(always)]
pub(super) fn axis(child: u32) -> Vec3<Unit> {
    direction(child).axis
}

/// The sum of three products, in steps of four.
#[inline(always)]
fn sum([x, y, z]: [(i32, Unit); 3]) -> i32 {
    let product = |(c, factor): (i32, Unit)| c.product(factor.to_bits());
    high(product(x) + product(y) + product(z)) << 2
}

/// A vector of the parent's frame, in steps of any size, in the child's.
#[inline(always)]
pub(super) fn inward(Vec3 { x, y, z }: Vec3<i32>, child: u32) -> Vec3<i32> {
    let Direction { axis, u, v, uv } = *direction(child);
    Vec3::new(
        sum([(x, u), (y, uv), (-z, axis.x)]),
        sum([(x, uv), (y, v), (-z, axis.y)]),
        sum([(x, axis.x), (y, axis.y), (z, axis.z)]),
    )
}

/// A vector of the child's frame, in steps of any size, in the parent's.
#[inline]
pub(super) fn outward(Vec3 { x, y, z }: Vec3<i32>, child: u32) -> Vec3<i32> {
    let Direction { axis, u, v, uv } = *direction(child);
    Vec3::new(
        sum([(x, u), (y, uv), (z, axis.x)]),
        sum([(x, uv), (y, v), (z, axis.y)]),
        sum([(-x, axis.x), (-y, axis.y), (z, axis.z)]),
    )
}
