//! The sphereflake: every sphere is touched by twelve smaller ones.
//!
//! Nothing of it is stored. A ray walks the tree from the root and skips a
//! subtree whose bounding sphere it misses.

use crate::Float;
use crate::ray::{Ray, Reach};
use crate::vec3::{Vec3, vec3};

/// The root sphere, and how the rest follow from it.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize))]
pub struct Sphereflake<F> {
    pub center: Vec3<F>,
    pub radius: F,
    /// Generations of children.
    pub depth: u32,
    /// A child's radius in its parent's.
    pub ratio: F,
    /// The root's u, v and w, orthonormal.
    pub frame: [Vec3<F>; 3],
}

/// The directions of a cuboctahedron in a sphere's (u, v, w): six around the
/// equator, three above and three below.
const CHILDREN: [[f64; 3]; 12] = {
    // √(3/4); then, at an elevation of ±atan √2, its cosine √(1/3), half of
    // that, and its sine √(2/3).
    const S: f64 = 0.866_025_403_784_438_6;
    const C: f64 = 0.577_350_269_189_625_8;
    const H: f64 = 0.288_675_134_594_812_9;
    const E: f64 = 0.816_496_580_927_726;
    [
        [1.0, 0.0, 0.0],
        [0.5, S, 0.0],
        [-0.5, S, 0.0],
        [-1.0, 0.0, 0.0],
        [-0.5, -S, 0.0],
        [0.5, -S, 0.0],
        [0.5, H, E],
        [-0.5, H, E],
        [0.0, -C, E],
        [0.0, C, -E],
        [-0.5, -H, -E],
        [0.5, -H, -E],
    ]
};

/// One sphere of the tree, met on a walk.
#[derive(Clone, Copy)]
struct Node<F> {
    center: Vec3<F>,
    radius: F,
    frame: [Vec3<F>; 3],
    /// Generations below it.
    depth: u32,
}

impl<F: Float> Sphereflake<F> {
    /// As of every shape. `start` is the sphere that the ray starts on, told by
    /// its center.
    pub(crate) fn crossings(
        &self,
        ray: &Ray<F>,
        start: Option<&Vec3<F>>,
        reach: &mut Reach<F>,
        visit: &mut impl FnMut(F, Vec3<F>) -> F,
    ) {
        let root = Node {
            center: self.center,
            radius: self.radius,
            frame: self.frame,
            depth: self.depth,
        };
        if self.may_meet(ray, self.center, self.radius, self.depth, reach) {
            self.walk(ray, start, &root, reach, visit);
        }
    }

    fn walk(
        &self,
        ray: &Ray<F>,
        start: Option<&Vec3<F>>,
        node: &Node<F>,
        reach: &mut Reach<F>,
        visit: &mut impl FnMut(F, Vec3<F>) -> F,
    ) {
        meet(ray, start, node, reach, visit);
        if node.depth == 0 {
            return;
        }
        let [u, v, w] = node.frame;
        let depth = node.depth - 1;
        let radius = node.radius * self.ratio;
        for direction in CHILDREN {
            let [du, dv, dw] = direction.map(F::lit);
            let out = u * du + v * dv + w * dw;
            let center = node.center + out * (node.radius + radius);
            if !self.may_meet(ray, center, radius, depth, reach) {
                continue;
            }
            // The smallest rotation that takes w to `out`; w·out = dw.
            let turn = (w + out) * (F::ONE / (F::ONE + dw));
            let frame = [u - turn * du, v - turn * dv, out];
            let child = Node {
                center,
                radius,
                frame,
                depth,
            };
            self.walk(ray, start, &child, reach, visit);
        }
    }

    /// Whether the ray, within reach, meets the sphere around a subtree.
    fn may_meet(
        &self,
        ray: &Ray<F>,
        center: Vec3<F>,
        radius: F,
        depth: u32,
        reach: &Reach<F>,
    ) -> bool {
        let bound = if depth == 0 {
            radius
        } else {
            radius * (F::ONE + self.ratio) / (F::ONE - self.ratio)
        };
        let (foot, half2) = chord(ray, center, bound);
        // Half the chord must bridge what the chord's middle lies out of reach.
        let beyond = (foot - reach.far).max(-foot);
        half2 >= F::ZERO && (beyond <= F::ZERO || beyond * beyond <= half2)
    }
}

/// Offers one sphere's crossings.
fn meet<F: Float>(
    ray: &Ray<F>,
    start: Option<&Vec3<F>>,
    node: &Node<F>,
    reach: &mut Reach<F>,
    visit: &mut impl FnMut(F, Vec3<F>) -> F,
) {
    let (foot, half2) = chord(ray, node.center, node.radius);
    if start == Some(&node.center) {
        reach.offer(foot + foot, node.center, visit);
    } else if half2 >= F::ZERO {
        let half = half2.sqrt();
        reach.offer(foot - half, node.center, visit);
        reach.offer(foot + half, node.center, visit);
    }
}

/// The t of the ray's point nearest to a sphere's center, and the square of
/// half the chord that the sphere cuts from the ray: negative for a miss. By
/// way of that point, since b² − c would lose a sphere of 0.1 at a distance of
/// 600 in f32.
fn chord<F: Float>(ray: &Ray<F>, center: Vec3<F>, radius: F) -> (F, F) {
    let to_center = center - ray.origin;
    let foot = to_center.dot(ray.direction);
    let off = to_center - ray.direction * foot;
    (foot, radius * radius - off.dot(off))
}

/// The root's frame unless a scene gives one: its poles on the y axis.
pub fn upright_frame<F: Float>() -> [Vec3<F>; 3] {
    [
        vec3(F::ONE, F::ZERO, F::ZERO),
        vec3(F::ZERO, F::ZERO, -F::ONE),
        vec3(F::ZERO, F::ONE, F::ZERO),
    ]
}
