use core::mem::swap;

use heapless::Vec;

use crate::num::{Square, Unit};

use super::flake::{MAX_DEPTH, Path, Radii, Sphereflake};
use super::node::{Node, scaled};

/// The way of a ray through the tree of spheres, the nearer child first.
///
/// Its lists are apart, as the compiler would clear them with it.
pub(super) struct Walk<'w> {
    flake: &'w Sphereflake,
    levels: &'w mut Levels,
    children: &'w mut Children,
    path: Path,
}

/// From the largest sphere down to the one whose children are visited.
pub(super) type Levels = Vec<Level, { MAX_DEPTH as usize }>;

/// Children that are still to be visited: of each level up to twelve, the
/// nearest last. The upper 28 bits are how much farther the child's foot is,
/// Q30 in radii, the lower four tell the child.
pub(super) type Children = Vec<i32, { 12 * MAX_DEPTH as usize }>;

/// A sphere on the way down.
pub(super) struct Level {
    node: Node,
    /// Where its children begin.
    first: usize,
}

impl<'w> Walk<'w> {
    #[inline]
    pub(super) fn new(
        flake: &'w Sphereflake,
        levels: &'w mut Levels,
        children: &'w mut Children,
    ) -> Self {
        Self {
            flake,
            levels,
            children,
            path: 0,
        }
    }

    /// Where the walk is.
    pub(super) fn path(&self) -> Path {
        self.path
    }

    /// Goes on from a sphere: to its nearest child within reach, or that of the
    /// deepest sphere that has one.
    #[inline]
    pub(super) fn next(&mut self, node: Node, reach: i64) -> Option<Node> {
        if self.levels.len() < usize::from(self.flake.depth) {
            self.descend(node, reach);
        }
        loop {
            let Level { node, first } = self.levels.last()?;
            if self.children.len() > *first
                && let Some(child) = self.children.pop()
            {
                let bound = scaled(node.child_bound(self.flake), node.radius);
                if node.foot_of(child & !15) - bound < reach {
                    let child = (child & 15) as u32;
                    let shift = 4 * (self.levels.len() as u32 - 1);
                    self.path = self.path & !(u32::MAX << shift) | child << shift;
                    return Some(node.child(self.flake, child));
                }
                // So are all that are left.
                self.children.truncate(*first);
            }
            self.levels.pop();
        }
    }

    /// Finds the children whose bound the ray passes through within reach.
    ///
    /// With child direction a, `step = 1 + ratio` and `b = step d·a`, the
    /// child's foot has the square `l² + step² - 2 step l·a - b²`. Children are
    /// six pairs of opposites, and the dot products share their terms.
    #[inline]
    fn descend(&mut self, node: Node, reach: i64) {
        let flake = self.flake;
        let first = self.children.len();
        let step = flake.steps.along;
        let child_bound = node.child_bound(flake);
        // Q56 -> Q27; a margin of what all roundings can do.
        let squares = (node.squared() as i64) + (step.square().to_bits() >> 4)
            - (child_bound.square().to_bits() >> 2);
        let threshold = (squares >> 29) as i32 - 16;
        let farther = flake.steps.dots(node.direction.map(Unit::to_bits), 30);
        // Q29 -> Q28, and so twice of it in Q27.
        let nearer = flake.steps.dots(node.foot.map(Radii::to_bits), 31);
        let bound = scaled(child_bound, node.radius);
        for (pair, (farther, nearer)) in (1..).zip(farther.into_iter().zip(nearer)) {
            // Q60 -> Q27
            let square = (farther.square() >> 33) as i32;
            if square + nearer.abs() < threshold {
                continue;
            }
            for (child, farther, nearer) in [(pair, farther, nearer), (pair + 6, -farther, -nearer)]
            {
                if square + nearer < threshold {
                    continue;
                }
                let distance = node.foot_of(farther);
                if distance + bound > 0 && distance - bound < reach {
                    self.insert(first, farther & !15 | child);
                }
            }
        }
        // There is room: a level for each generation, twelve children each.
        let _ = self.levels.push(Level { node, first });
    }

    /// Keeps the list from `first` on in falling order.
    #[inline]
    fn insert(&mut self, first: usize, child: i32) {
        let mut lower = child;
        for slot in self.children.iter_mut().skip(first) {
            if *slot < lower {
                swap(slot, &mut lower);
            }
        }
        let _ = self.children.push(lower);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What docs/fixed-point.md says; less where pointers are short.
    #[test]
    fn a_walk_takes_as_many_bytes_as_documented() {
        let size = size_of::<Levels>() + size_of::<Children>();
        assert!(size <= 800, "{size}");
    }
}
