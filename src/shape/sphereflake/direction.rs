//! The twelve directions of a sphere's children, those of a cuboctahedron: six
//! around the equator, three above and their opposites below.

use fixed::types::I3F29;

use crate::Vec3;
use crate::num::{Product, Unit};
use crate::vector::round_unit;

/// A child's direction a in its parent's frame (u, v, w), and what turns w to
/// it: the smallest rotation, `u' = u - turn.0 (w + a)`, `v' = v - turn.1 (w + a)`,
/// `w' = a`, with `turn = (a.u, a.v) / (1 + a.w)`.
struct Direction {
    axis: Vec3<Unit>,
    turn: [I3F29; 2],
}

/// sqrt(3/4).
pub(super) const EQUATOR: Unit = Unit::lit("0.866025403784438646763723");
/// sqrt(1/12); twice that is the cosine of the elevation, atan(sqrt 2).
pub(super) const ASIDE: Unit = Unit::lit("0.288675134594812882254575");
/// sqrt(2/3), the sine of the elevation.
pub(super) const ELEVATION: Unit = Unit::lit("0.816496580927726032732428");

const DIRECTIONS: [Direction; 12] = {
    const fn unit(bits: i64) -> Unit {
        Unit::from_bits(bits as i32)
    }
    const fn direction(x: i64, y: i64, z: i64) -> Direction {
        // Q30 / Q30 -> Q29, rounded
        const fn turn(part: i64, z: i64) -> I3F29 {
            let whole = (1 << 30) + z;
            I3F29::from_bits((((part << 30) / whole + 1) >> 1) as i32)
        }
        Direction {
            axis: Vec3::new(unit(x), unit(y), unit(z)),
            turn: [turn(x, z), turn(y, z)],
        }
    }
    const ONE: i64 = 1 << 30;
    const S: i64 = EQUATOR.to_bits() as i64;
    const H: i64 = ASIDE.to_bits() as i64;
    const E: i64 = ELEVATION.to_bits() as i64;
    [
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
    ]
};

#[inline(always)]
fn direction(child: u32) -> &'static Direction {
    // Children are 1 to 12; `min` tells the compiler so.
    &DIRECTIONS[(child.wrapping_sub(1) as usize).min(11)]
}

/// The direction of a child.
#[inline(always)]
pub(super) fn axis(child: u32) -> Vec3<Unit> {
    direction(child).axis
}

/// A vector of the parent's frame in the child's.
#[inline]
pub(super) fn inward(v: Vec3<Unit>, child: u32) -> Vec3<Unit> {
    let Direction { axis, turn } = direction(child);
    let along = v.cosine(*axis);
    // Up to 4: v is up to 2 long.
    let sum = i64::from(v.z.to_bits()) + i64::from(along.to_bits());
    let turned = |c: Unit, turn: I3F29| {
        let product = (sum * i64::from(turn.to_bits()) + (1 << 28)) >> 29;
        Unit::from_bits((i64::from(c.to_bits()) - product) as i32)
    };
    Vec3::new(turned(v.x, turn[0]), turned(v.y, turn[1]), along)
}

/// A unit vector of the child's frame in the parent's.
#[inline]
pub(super) fn outward(v: Vec3<Unit>, child: u32) -> Vec3<Unit> {
    let Direction { axis, turn } = direction(child);
    // Q30 * Q29 -> Q59 -> Q30
    let sum = turn[0].product(v.x) + turn[1].product(v.y);
    let sum = (sum.to_bits() + (1 << 28)) >> 29;
    let along = i64::from(v.z.to_bits()) - sum;
    let part = |axis: Unit| round_unit(along * i64::from(axis.to_bits()), 30).to_bits();
    let turned = |c: i64, axis: Unit| Unit::from_bits((c + i64::from(part(axis))) as i32);
    Vec3::new(
        turned(v.x.to_bits().into(), axis.x),
        turned(v.y.to_bits().into(), axis.y),
        turned(-sum, axis.z),
    )
}
