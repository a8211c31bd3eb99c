use core::mem::swap;

use heapless::Vec;

use crate::math::high;

use super::flake::{MAX_DEPTH, NodePath, Sphereflake};
use super::node::Node;
use super::word::upper_product;

/// The way of a ray through the tree of spheres, the nearer child first.
///
/// Its lists are apart, as the compiler would clear them with it.
pub(super) struct Walk<'w> {
    pub(super) flake: &'w Sphereflake,
    pub(super) nodes: &'w mut Nodes,
    pub(super) waiting: &'w mut Waiting,
    pub(super) goal: Goal,
    /// The sphere that the ray starts on, which is no hit.
    pub(super) start: NodePath,
    /// What is farther is passed over, in steps of a `Length`.
    pub(super) reach: i32,
}

/// What a walk looks for.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Goal {
    Nearest,
    Any,
    All,
    /// The sphere that the ray starts on, and no other.
    Start,
}

/// From the largest sphere down to where the walk is.
pub(super) type Nodes = Vec<Node, { MAX_DEPTH as usize + 1 }>;

/// Children that are still to be visited: of the deepest level up to twelve, of
/// each above it one less, the nearest last.
pub(super) type Waiting = Vec<i32, { 11 * MAX_DEPTH as usize + 1 }>;

/// The upper 16 bits are how much farther a child's foot is, Q14 in radii. Of
/// the lower, four tell the level of its parent, four the child.
type Candidates = Vec<i32, 12>;

/// Set where the ray's line meets the child's sphere itself for sure.
const SURE: i32 = 1 << 8;

/// What 16 bits leave open: of squares 34 * 2^-14, Q27; of how much farther a
/// foot is 7 * 2^-14, Q29.
const SQUARE_MARGIN: i32 = 34 << 13;
const FARTHER_MARGIN: i32 = 7 << 15;

impl Walk<'_> {
    /// Goes on to the nearest child within reach, or that of the deepest sphere
    /// that has one.
    #[inline]
    pub(super) fn next(&mut self) -> Option<()> {
        loop {
            let next = self.waiting.pop()?;
            let (level, child) = (next as u32 >> 4 & 15, next as u32 & 15);
            self.nodes.truncate(level as usize + 1);
            let parent = self.nodes.last()?;
            if distance(parent, next) - reach_of_child(parent, self.flake) <= self.reach {
                let node = parent.child(self.flake, child, 4 * level);
                let _ = self.nodes.push(node);
                return Some(());
            }
        }
    }

    /// Lists the children whose bound the ray passes through within reach.
    /// Tells whether the goal is reached, as one is hit for sure.
    #[inline]
    pub(super) fn descend(&mut self, squared: i64) -> bool {
        let level = self.nodes.len() as u32 - 1;
        if level >= u32::from(self.flake.depth) {
            return false;
        }
        let Some(node) = self.nodes.last() else {
            return false;
        };
        let path = node.path;
        let mut candidates = Candidates::new();
        find(node, self.flake, high(squared), &mut candidates);
        let bound = reach_of_child(node, self.flake);
        let first = self.waiting.len();
        for &candidate in &candidates {
            let distance = distance(node, candidate);
            if distance + bound < 0 || distance - bound > self.reach {
                continue;
            }
            if candidate & SURE != 0
                && self.goal != Goal::All
                && distance > bound
                && distance < self.reach
                && path | (candidate as u32 & 15) << (4 * level) != self.start
            {
                if self.goal == Goal::Any {
                    return true;
                }
                self.reach = distance;
            }
            insert(self.waiting, first, candidate & !SURE | (level << 4) as i32);
        }
        false
    }
}

/// Keeps the list from `first` on in falling order.
#[inline]
fn insert(waiting: &mut Waiting, first: usize, child: i32) {
    let is_only = waiting.len() == first;
    // There is room, as said above.
    let _ = waiting.push(child);
    if is_only {
        return;
    }
    let mut slots = waiting.iter_mut().skip(first).rev();
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

/// From the ray's origin to a child's foot, in steps of a `Length`.
#[inline(always)]
fn distance(parent: &Node, candidate: i32) -> i32 {
    // Q30 * Q31 -> Q61 -> Q29 -> Q28
    high(parent.distance) + (upper_product(candidate, parent.radius.to_bits()) >> 1)
}

/// How far all of a child reaches from its foot, in steps of a `Length`,
/// rounded up.
#[inline(always)]
fn reach_of_child(parent: &Node, flake: &Sphereflake) -> i32 {
    let bound = parent.child_bound(flake).to_bits() + FARTHER_MARGIN;
    // Q29 * Q31 -> Q60 -> Q28
    upper_product(bound, parent.radius.to_bits()) + 3
}

/// Finds the children whose bound the ray's line may pass through, by products
/// of 16 bits.
///
/// With child direction a, `step = 1 + ratio` and `b = step d·a`, the child's
/// foot has the square `l² + step² - 2 step l·a - b²`. Children are six pairs of
/// opposites, and the dot products share their terms.
#[inline(always)]
fn find(node: &Node, flake: &Sphereflake, squared: i32, candidates: &mut Candidates) {
    let (steps, step) = (&flake.steps, flake.coarse_step());
    // Q15 -> Q30 -> Q27
    let square = |c: u32| ((c * c) >> 3) as i32;
    // Q26 -> Q27
    let squares = (squared << 1) + square(step.to_bits().into());
    let bound = (node.child_bound(flake).to_bits() >> 14) as u32 + 1;
    let least = squares - square(bound) - SQUARE_MARGIN;
    let sure = squares - square(flake.ratio.to_bits() >> 17) + SQUARE_MARGIN;
    // Q30 -> Q14 -> Q29 -> Q14; Q29 -> Q13 -> Q28, and so twice of it in Q27.
    let farther = steps.dots(step, node.direction.map(|c| c.to_bits() >> 16), 15);
    let nearer = steps.dots(step, node.foot.map(|c| c.to_bits() >> 16), 0);
    for ((pair, farther), nearer) in (1..).zip(farther).zip(nearer) {
        // Q14 -> Q28 -> Q27
        let square = (farther * farther) >> 1;
        // Up to a step, which is in the margin.
        let sign = nearer >> 31;
        let nearer = nearer ^ sign;
        if square + nearer < least {
            continue;
        }
        let child = |sign: i32| ((farther ^ sign) << 16) + pair + (sign & 6);
        let is_sure = if square + nearer > sure { SURE } else { 0 };
        let _ = candidates.push(child(sign) | is_sure);
        if square - nearer >= least {
            let _ = candidates.push(child(!sign));
        }
    }
}

#[cfg(test)]
mod tests {
    use fixed::types::{I1F31, U0F32};

    use super::super::flake::{Radii, SphereflakeParams};
    use super::*;
    use crate::geometry::sphereflake::direction::axis;
    use crate::math::{Length, Unit, Vec3, direction, high};

    /// What docs/fixed-point.md says; less where pointers are short.
    #[test]
    fn a_walk_takes_as_many_bytes_as_documented() {
        let size = size_of::<Nodes>() + size_of::<Waiting>();
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

    /// A line that passes through the bound.
    fn line(flake: &Sphereflake, random: &mut fastrand::Rng) -> Option<Node> {
        let mut component = || random.i64(-(1 << 30)..1 << 30);
        let along = direction(Vec3::new(component(), component(), component()))?;
        let across =
            direction(along.cross(direction(Vec3::new(component(), component(), component()))?))?;
        let far = random.i32(0..flake.bound.to_bits());
        Some(Node {
            foot: across.map(|c| Radii::from_bits(upper_product(c.to_bits(), far) << 2)),
            direction: along,
            distance: 0,
            radius: I1F31::from_num(0.25),
            bound: flake.bound,
            path: 0,
        })
    }

    /// No child is missed, and none is said to be hit that is not.
    #[test]
    fn sixteen_bits_are_enough() {
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
                find(&node, &flake, high(node.squared()), &mut candidates);
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
                    let is_sure = it.is_some_and(|it| it & SURE != 0);
                    assert!(
                        it.is_some() || !is_met,
                        "{ratio}, {depth}, {child}: {node:?}"
                    );
                    assert!(
                        !is_sure || square < ratio * ratio,
                        "{ratio}, {child}: {node:?}"
                    );
                    if let Some(it) = it {
                        let error = f64::from(it >> 16) / 16384.0 - farther;
                        let margin = f64::from(FARTHER_MARGIN) / f64::from(1 << 29);
                        assert!(error.abs() < margin, "{ratio}, {child}: {error}");
                    }
                    for (count, is) in seen.iter_mut().zip([it.is_some(), is_met, is_sure]) {
                        *count += u32::from(is);
                    }
                }
            }
        }
        let [found, met, sure] = seen;
        assert!(met > 100_000 && sure > 10_000, "{seen:?}");
        // Little is visited in vain.
        assert!(found < met + met / 20, "{seen:?}");
    }
}
