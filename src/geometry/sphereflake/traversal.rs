use core::mem::swap;

use heapless::Vec;

use super::node::Node;
use super::parameters::{MAX_DEPTH, NodePath, Sphereflake};
use crate::math::{high, upper_word};

/// A traversal of the tree of spheres by a ray. It visits nearer children first.
///
/// The traversal borrows its two lists, so that constructing a traversal does not fill them with
/// zeros.
pub(super) struct Traversal<'w> {
    pub(super) flake: &'w Sphereflake,
    pub(super) nodes: &'w mut NodeStack,
    pub(super) pending: &'w mut PendingChildren,
    pub(super) query: Query,
    /// Path of the sphere that the ray starts on. This sphere does not count as a hit.
    pub(super) origin: NodePath,
    /// Largest distance of interest, in units of 2^-28.
    pub(super) t_max: i32,
}

/// The result that a traversal computes.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Query {
    /// The nearest hit.
    Nearest,
    /// Any hit.
    Any,
    /// All hits.
    All,
    /// The hit of the sphere that the ray starts on.
    Origin,
}

/// Stack of nodes, from the root sphere to the current sphere.
pub(super) type NodeStack = Vec<Node, { MAX_DEPTH as usize + 1 }>;

/// Children that are still to be visited. The nearest child is the last entry. The list has up to
/// twelve children of the deepest level and up to eleven children of each level above.
pub(super) type PendingChildren = Vec<i32, { 11 * MAX_DEPTH as usize + 1 }>;

/// Children whose bounding sphere the line of a ray may cross.
///
/// The foot of a sphere is the point of the line that is nearest to the center of the sphere. The
/// upper 16 bits of an entry are the distance from the parent's foot to the child's foot, in radii
/// of the parent and in Q14. The lower bits are the level of the parent (four bits) and the number
/// of the child (four bits).
type Candidates = Vec<i32, 12>;

/// Flag which means that the line is certain to cross the sphere of the child. Without this flag,
/// the line may only cross the bounding sphere of the child's subtree.
const CERTAIN: i32 = 1 << 8;

/// Error bound of squares that are computed with 16-bit factors: 34 * 2^-14, in Q27.
const SQUARE_MARGIN: i32 = 34 << 13;
/// Error bound of the distance from a parent's foot to a child's foot, which is computed with
/// 16-bit factors: 7 * 2^-14, in Q29.
const FARTHER_MARGIN: i32 = 7 << 15;

impl Traversal<'_> {
    /// Moves to the nearest pending child of the deepest level that has one. Returns `None` if
    /// no child is pending.
    pub(super) fn advance(&mut self) -> Option<()> {
        loop {
            let next = self.pending.pop()?;
            let (level, child) = (next as u32 >> 4 & 15, next as u32 & 15);
            self.nodes.truncate(level as usize + 1);
            let parent = self.nodes.last()?;
            if foot_distance(parent, next) - child_reach(parent, self.flake) <= self.t_max {
                let node = parent.child(self.flake, child, 4 * level);
                let _ = self.nodes.push(node);
                return Some(());
            }
        }
    }

    /// Adds children to the list of pending children, if the ray crosses their bounding sphere
    /// before `t_max`. Returns true if the query asks for any hit and the ray is certain to hit a
    /// child.
    pub(super) fn descend(&mut self, foot_squared: i64) -> bool {
        let level = self.nodes.len() as u32 - 1;
        if level >= u32::from(self.flake.depth) {
            return false;
        }
        let Some(node) = self.nodes.last() else {
            return false;
        };
        let path = node.path;
        let mut candidates = Candidates::new();
        find_candidates(node, self.flake, high(foot_squared), &mut candidates);
        let bound = child_reach(node, self.flake);
        let first = self.pending.len();
        for &candidate in &candidates {
            let distance = foot_distance(node, candidate);
            if distance + bound < 0 || distance - bound > self.t_max {
                continue;
            }
            if candidate & CERTAIN != 0
                && self.query != Query::All
                && distance > bound
                && distance < self.t_max
                && path | (candidate as u32 & 15) << (4 * level) != self.origin
            {
                if self.query == Query::Any {
                    return true;
                }
                self.t_max = distance;
            }
            insert(
                self.pending,
                first,
                candidate & !CERTAIN | (level << 4) as i32,
            );
        }
        false
    }
}

/// Inserts a child into the list. The part of the list from the index `first` on is kept in
/// descending order.
fn insert(pending: &mut PendingChildren, first: usize, child: i32) {
    let is_only = pending.len() == first;
    // The push cannot fail, because the list has room for all pending children of any tree.
    let _ = pending.push(child);
    if is_only {
        return;
    }
    let mut slots = pending.iter_mut().skip(first).rev();
    let Some(mut lower) = slots.next() else {
        return;
    };
    for slot in slots {
        if *slot >= *lower {
            break;
        }
        swap(slot, lower);
        lower = slot;
    }
}

/// Returns the distance from the ray's origin to a child's foot, in units of 2^-28. The child's
/// foot is the point of the ray nearest to the center of the child.
#[inline(always)]
fn foot_distance(parent: &Node, candidate: i32) -> i32 {
    // The upper word of the product of Q30 and Q31 has Q29, which is shifted to Q28.
    high(parent.distance) + (upper_word(candidate, parent.radius.to_bits()) >> 1)
}

/// Returns how far a child's subtree can extend along the ray, measured from the child's foot. The
/// result is in units of 2^-28 and rounded up.
#[inline(always)]
fn child_reach(parent: &Node, flake: &Sphereflake) -> i32 {
    let bound = parent.child_bound(flake).to_bits() + FARTHER_MARGIN;
    // The product of Q29 and Q31 has Q60; its upper word has Q28.
    upper_word(bound, parent.radius.to_bits()) + 3
}

/// Finds the children whose bounding sphere the line of a ray may cross. The computation uses
/// 16-bit factors.
///
/// Let `l` be the foot, `d` the direction of the ray, `a` the direction of a child,
/// `step = 1 + ratio` and `b = step d·a`. The squared distance of the child's center from the line
/// is `l² + step² - 2 step l·a - b²`. The children form six pairs. The two children of a pair are
/// opposite, so their dot products differ only in sign and are computed once.
#[inline(always)]
fn find_candidates(
    node: &Node,
    flake: &Sphereflake,
    foot_squared: i32,
    candidates: &mut Candidates,
) {
    let (steps, step) = (&flake.steps, flake.step_u16());
    // The square of a Q15 number has Q30 and is shifted to Q27.
    let square = |c: u32| ((c * c) >> 3) as i32;
    // The squared length of the foot is shifted from Q26 to Q27.
    let squares = (foot_squared << 1) + square(step.to_bits().into());
    let bound = (node.child_bound(flake).to_bits() >> 14) as u32 + 1;
    let least = squares - square(bound) - SQUARE_MARGIN;
    let certain = squares - square(flake.ratio.to_bits() >> 17) + SQUARE_MARGIN;
    // The direction is shifted from Q30 to Q14; its products with Q15 have Q29 and are shifted
    // to Q14. The foot is shifted from Q29 to Q13; its products have Q28, which is twice the
    // dot product in Q27.
    let farther = steps.dots(step, node.direction.map(|c| c.to_bits() >> 16), 15);
    let nearer = steps.dots(step, node.foot.map(|c| c.to_bits() >> 16), 0);
    for ((pair, farther), nearer) in (1..).zip(farther).zip(nearer) {
        // The square of a Q14 number has Q28 and is shifted to Q27.
        let square = (farther * farther) >> 1;
        // Instead of the magnitude of a negative number, its bitwise complement is used. It differs
        // from the magnitude by one, which the margin includes.
        let sign = nearer >> 31;
        let nearer = nearer ^ sign;
        if square + nearer < least {
            continue;
        }
        let child = |sign: i32| ((farther ^ sign) << 16) + pair + (sign & 6);
        let certain_flag = if square + nearer > certain {
            CERTAIN
        } else {
            0
        };
        let _ = candidates.push(child(sign) | certain_flag);
        if square - nearer >= least {
            let _ = candidates.push(child(!sign));
        }
    }
}

#[cfg(test)]
mod tests {
    use fixed::types::{I1F31, U0F32};

    use super::super::child_frame::axis;
    use super::super::parameters::{Radii, SphereflakeParams};
    use super::*;
    use crate::math::{Length, Unit, Vec3, direction, high};

    /// Checks the number of bytes that docs/fixed-point.md states for a traversal. Targets with
    /// pointers shorter than those of a PC need fewer bytes.
    #[test]
    fn traversal_memory_is_as_documented() {
        let size = size_of::<NodeStack>() + size_of::<PendingChildren>();
        assert!(size <= 808, "{size}");
    }

    fn flake(ratio: f64, depth: u8) -> Sphereflake {
        Sphereflake::new(SphereflakeParams {
            center: Vec3::new(Length::ZERO, Length::ZERO, Length::ZERO),
            frame: [
                Vec3::new(Unit::ONE, Unit::ZERO, Unit::ZERO),
                Vec3::new(Unit::ZERO, Unit::ONE, Unit::ZERO),
            ],
            radius: U0F32::from_num(0.25),
            ratio: U0F32::from_num(ratio),
            depth,
        })
    }

    /// Returns a random line through the bounding sphere of a flake.
    fn line(flake: &Sphereflake, random: &mut fastrand::Rng) -> Option<Node> {
        let mut component = || random.i64(-(1 << 30)..1 << 30);
        let along = direction(Vec3::new(component(), component(), component()))?;
        let across =
            direction(along.cross(direction(Vec3::new(component(), component(), component()))?))?;
        let far = random.i32(0..flake.bound.to_bits());
        Some(Node {
            foot: across.map(|c| Radii::from_bits(upper_word(c.to_bits(), far) << 2)),
            direction: along,
            distance: 0,
            radius: I1F31::from_num(0.25),
            bound: flake.bound,
            path: 0,
        })
    }

    /// Checks that the search with 16-bit factors finds every child that the line may cross. Also
    /// checks that the line hits every child that is marked as certain.
    #[test]
    fn sixteen_bit_factors_find_all_children() {
        let mut random = fastrand::Rng::with_seed(1);
        let mut seen = [0; 3];
        for (ratio, depth) in [
            (0.1, 1),
            (0.1, 3),
            (1.0 / 3.0, 1),
            (1.0 / 3.0, 6),
            (0.5, 1),
            (0.5, 8),
        ] {
            let flake = flake(ratio, depth);
            for _ in 0..20_000 {
                let Some(node) = line(&flake, &mut random) else {
                    continue;
                };
                let mut candidates = Candidates::new();
                find_candidates(&node, &flake, high(node.foot_squared()), &mut candidates);
                let step = 1.0 + ratio;
                let bound: f64 = node.child_bound(&flake).to_num();
                for child in 1..=12 {
                    let axis = axis(child).map(Unit::to_num::<f64>);
                    let along = |v: Vec3<f64>| {
                        let product = v.zip(axis, |c, a| c * a);
                        step * (product.x + product.y + product.z)
                    };
                    let foot = node.foot.map(|c| c.to_num::<f64>());
                    let farther = along(node.direction.map(|c| c.to_num::<f64>()));
                    let square = foot.map(|c| c * c);
                    let square = square.x + square.y + square.z + step * step
                        - 2.0 * along(foot)
                        - farther * farther;
                    let it = candidates.iter().find(|it| **it as u32 & 15 == child);
                    let is_met = square < bound * bound;
                    let is_certain = it.is_some_and(|it| it & CERTAIN != 0);
                    assert!(
                        it.is_some() || !is_met,
                        "{ratio}, {depth}, {child}: {node:?}"
                    );
                    assert!(
                        !is_certain || square < ratio * ratio,
                        "{ratio}, {child}: {node:?}"
                    );
                    if let Some(it) = it {
                        let error = f64::from(it >> 16) / 16384.0 - farther;
                        let margin = f64::from(FARTHER_MARGIN) / f64::from(1 << 29);
                        assert!(error.abs() < margin, "{ratio}, {child}: {error}");
                    }
                    for (count, is) in seen.iter_mut().zip([it.is_some(), is_met, is_certain]) {
                        *count += u32::from(is);
                    }
                }
            }
        }
        let [found, met, certain] = seen;
        assert!(met > 100_000 && certain > 10_000, "{seen:?}");
        // The search finds at most 5 % more children than the lines really cross.
        assert!(found < met + met / 20, "{seen:?}");
    }
}
