//! Sphereflake: twelve smaller spheres touch every sphere.
//!
//! The spheres are not stored. Each ray traverses the tree from the root and skips
//! subtrees whose bounding sphere it misses.

use crate::Float;
use crate::ray::{Interval, Ray};
use crate::vec3::{Vec3, vec3};

/// Root sphere and the parameters of its descendants.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize))]
pub struct Sphereflake<F> {
    pub center: Vec3<F>,
    pub radius: F,
    /// Generations of children.
    pub depth: u32,
    /// Radius of a child relative to its parent.
    pub ratio: F,
    /// Orthonormal basis u, v, w of the root.
    pub frame: [Vec3<F>; 3],
}

/// Directions of the children in the basis (u, v, w) of their parent, the vertices of
/// a cuboctahedron: six around the equator, three above and three below.
const CHILDREN: [[f64; 3]; 12] = {
    // S = √(3/4). The elevation ±atan √2 has the cosine C = √(1/3), H = C/2 and the
    // sine E = √(2/3).
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

/// Sphere of the tree, during a traversal.
#[derive(Clone, Copy)]
struct Node<F> {
    center: Vec3<F>,
    radius: F,
    frame: [Vec3<F>; 3],
    /// Generations below this sphere.
    depth: u32,
}

impl<F: Float> Sphereflake<F> {
    /// Reports every crossing in the interval to `visit`, see `Shape::crossings`.
    /// `start` is the center of the sphere on which the ray starts.
    pub(crate) fn crossings(
        &self,
        ray: &Ray<F>,
        start: Option<&Vec3<F>>,
        interval: &mut Interval<F>,
        visit: &mut impl FnMut(F, Vec3<F>) -> F,
    ) {
        let root = Node {
            center: self.center,
            radius: self.radius,
            frame: self.frame,
            depth: self.depth,
        };
        if self.may_hit(ray, self.center, self.radius, self.depth, interval) {
            self.traverse(ray, start, &root, interval, visit);
        }
    }

    /// Intersects a sphere and its descendants.
    fn traverse(
        &self,
        ray: &Ray<F>,
        start: Option<&Vec3<F>>,
        node: &Node<F>,
        interval: &mut Interval<F>,
        visit: &mut impl FnMut(F, Vec3<F>) -> F,
    ) {
        intersect(ray, start, node, interval, visit);
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
            if !self.may_hit(ray, center, radius, depth, interval) {
                continue;
            }
            // Smallest rotation that turns w to `out`; w·out = dw.
            let turn = (w + out) * (F::ONE / (F::ONE + dw));
            let frame = [u - turn * du, v - turn * dv, out];
            let child = Node {
                center,
                radius,
                frame,
                depth,
            };
            self.traverse(ray, start, &child, interval, visit);
        }
    }

    /// Returns true if the ray hits the bounding sphere of a subtree in the interval.
    fn may_hit(
        &self,
        ray: &Ray<F>,
        center: Vec3<F>,
        radius: F,
        depth: u32,
        interval: &Interval<F>,
    ) -> bool {
        let bound = if depth == 0 {
            radius
        } else {
            radius * (F::ONE + self.ratio) / (F::ONE - self.ratio)
        };
        let (foot, half2) = chord(ray, center, bound);
        // The interval overlaps the chord if half the chord is longer than the distance
        // from the chord's midpoint to the interval.
        let beyond = (foot - interval.far).max(-foot);
        half2 >= F::ZERO && (beyond <= F::ZERO || beyond * beyond <= half2)
    }
}

/// Intersects one sphere.
fn intersect<F: Float>(
    ray: &Ray<F>,
    start: Option<&Vec3<F>>,
    node: &Node<F>,
    interval: &mut Interval<F>,
    visit: &mut impl FnMut(F, Vec3<F>) -> F,
) {
    let (foot, half2) = chord(ray, node.center, node.radius);
    if start == Some(&node.center) {
        interval.report(foot + foot, node.center, visit);
    } else if half2 >= F::ZERO {
        let half = half2.sqrt();
        interval.report(foot - half, node.center, visit);
        interval.report(foot + half, node.center, visit);
    }
}

/// Returns t of the ray's point nearest to the center of a sphere, and the square of
/// half the chord, negative for a miss. In f32, the textbook discriminant b² − c
/// would lose a sphere of radius 0.1 at a distance of 600.
fn chord<F: Float>(ray: &Ray<F>, center: Vec3<F>, radius: F) -> (F, F) {
    let to_center = center - ray.origin;
    let foot = to_center.dot(ray.direction);
    let offset = to_center - ray.direction * foot;
    (foot, radius * radius - offset.dot(offset))
}

/// Returns the default basis of the root, whose w points along the y axis.
pub fn upright_frame<F: Float>() -> [Vec3<F>; 3] {
    [
        vec3(F::ONE, F::ZERO, F::ZERO),
        vec3(F::ZERO, F::ZERO, -F::ONE),
        vec3(F::ZERO, F::ONE, F::ZERO),
    ]
}
