//! Traces the tree of rays behind one pixel and prints it (Whitted 1980).
//!
//! Each line of the output shows a ray. The line starts with the kind of the ray: C for camera, R
//! for reflected, T for transmitted, S for shadow.
//!
//! ```text
//! C object 1: weight 1.0000, local 0.0120
//! ├─ S light 0: visible
//! ├─ R background: weight 0.0800, local (0.1600, 0.3300, 0.6800)
//! └─ T object 1 from inside: weight 0.9300, local 0.0000
//! ```

mod text;

use embedded_graphics_core::geometry::Size;
use whitted::observer::{Observer, RayKind, RayNode, Stats};
use whitted::render::Output;
use whitted::{Color, PreparedScene, Radiance, Real, Renderer};

/// All rays that contribute to a pixel's color.
#[derive(Clone, Debug)]
pub struct RayTree {
    /// Nodes of the tree in depth-first order. A parent comes before its children.
    pub nodes: Vec<TreeNode>,
    /// Linear color of the pixel.
    pub color: Color<Radiance>,
    /// Conversion of the color to display colors.
    pub output: Output,
    /// Numbers of rays by kind.
    pub stats: Stats,
}

/// A node of the ray tree. It stands for the end point of a ray, and has the shadow rays that start
/// at this point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TreeNode {
    /// Object, weight and local color of the node.
    pub node: RayNode,
    /// Shadow rays, one for each light that the surface faces.
    pub shadows: Vec<ShadowRay>,
}

/// A ray between a surface and a light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ShadowRay {
    /// Index of the light.
    pub light: u16,
    /// Share of the light that reaches the surface, or `None` if an opaque object blocks the light.
    pub transmittance: Option<Color<Real>>,
}

/// Traces the pixel (`x`, `y`) of a picture. Returns `None` if the pixel is outside the picture.
pub fn trace(scene: &PreparedScene<'_>, size: Size, [x, y]: [u32; 2]) -> Option<RayTree> {
    if x >= size.width || y >= size.height {
        return None;
    }
    let mut renderer = Renderer::with_observer(scene, size, Collector::default());
    let color = renderer.pixel(x, y);
    let Collector { nodes, stats, .. } = renderer.observer().clone();
    Some(RayTree {
        nodes,
        color,
        output: renderer.output(),
        stats,
    })
}

/// Observer that records the nodes of a ray tree.
#[derive(Clone, Debug, Default)]
struct Collector {
    nodes: Vec<TreeNode>,
    /// Shadow rays since the last node. The renderer reports the shadow rays of a node before the
    /// node itself.
    shadows: Vec<ShadowRay>,
    stats: Stats,
}

impl Observer for Collector {
    fn ray(&mut self, kind: RayKind) {
        self.stats.ray(kind);
    }

    fn shadow(&mut self, light: u16, transmittance: Option<Color<Real>>) {
        self.shadows.push(ShadowRay {
            light,
            transmittance,
        });
    }

    fn node(&mut self, node: &RayNode) {
        self.nodes.push(TreeNode {
            node: *node,
            shadows: std::mem::take(&mut self.shadows),
        });
    }
}
