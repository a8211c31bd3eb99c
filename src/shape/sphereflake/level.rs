use core::mem::swap;

use heapless::Vec;

use crate::num::Unit;

use super::flake::{Radii, Sphereflake};
use super::node::{Node, scaled};

/// A sphere on the way down, and its children that are still to be visited.
#[derive(Clone, Debug)]
pub(super) struct Level {
    node: Node,
    /// The nearest last. The upper 28 bits are how much farther the child's
    /// foot is, Q30 in radii, the lower four tell the child.
    children: Vec<i32, 12>,
}

impl Level {
    /// Finds the children whose bound the ray passes through within reach.
    ///
    /// With child direction a, `step = 1 + ratio` and `b = step d·a`, the
    /// child's foot has the square `l² + step² - 2 step l·a - b²`. Children are
    /// six pairs of opposites, and the dot products share their terms.
    #[inline]
    pub(super) fn new(flake: &Sphereflake, node: Node, reach: i64) -> Self {
        let step = flake.step();
        let child_bound = node.child_bound(flake);
        // Q56 -> Q27; a margin of what all roundings can do.
        let squares = (node.squared() as i64) + (step.wide_mul(step).to_bits() >> 4)
            - (child_bound.wide_mul(child_bound).to_bits() >> 2);
        let threshold = (squares >> 29) as i32 - 16;
        let farther = flake.dots(node.direction.map(Unit::to_bits), 30);
        // Q29 -> Q28, and so twice of it in Q27.
        let nearer = flake.dots(node.foot.map(Radii::to_bits), 31);
        let bound = scaled(child_bound, node.radius);
        let mut children = Vec::new();
        for (pair, (farther, nearer)) in (1..).zip(farther.into_iter().zip(nearer)) {
            // Q60 -> Q27
            let square = ((i64::from(farther) * i64::from(farther)) >> 33) as i32;
            for (child, farther, nearer) in [(pair, farther, nearer), (pair + 6, -farther, -nearer)]
            {
                if square + nearer < threshold {
                    continue;
                }
                let distance = node.foot_of(farther);
                if distance + bound <= 0 || distance - bound >= reach {
                    continue;
                }
                insert(&mut children, farther & !15 | child);
            }
        }
        Self { node, children }
    }

    pub(super) fn node(&self) -> &Node {
        &self.node
    }

    /// The nearest child that is left; none if all are out of reach.
    #[inline]
    pub(super) fn next(&mut self, flake: &Sphereflake, reach: i64) -> Option<u32> {
        let child = self.children.pop()?;
        let bound = scaled(self.node.child_bound(flake), self.node.radius);
        (self.node.foot_of(child & !15) - bound < reach).then_some((child & 15) as u32)
    }
}

/// Keeps the list in falling order. There is room for all twelve.
#[inline]
fn insert(children: &mut Vec<i32, 12>, child: i32) {
    let mut lower = child;
    for slot in children.iter_mut() {
        if *slot < lower {
            swap(slot, &mut lower);
        }
    }
    let _ = children.push(lower);
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What docs/fixed-point.md says.
    #[test]
    fn a_level_takes_as_many_bytes_as_documented() {
        assert_eq!(size_of::<Level>(), 96);
    }
}
