//! The tree of rays of a pixel, drawn as in Whitted's article.
//!
//! ```text
//! E object 1: weight 1.0000, local 0.0120
//! ├─ S light 0: reached
//! ├─ R background: weight 0.0800, local (0.1600, 0.3300, 0.6800)
//! └─ T object 1 from inside: weight 0.9300, local 0.0000
//! ```

use std::fmt::{self, Write};

use embedded_graphics_core::geometry::{Point, Size};
use embedded_graphics_core::pixelcolor::{Rgb888, RgbColor};
use whitted::observer::{Observer, RayKind, RayNode, Stats};
use whitted::render::{DisplayColor, Output};
use whitted::{Color, PreparedScene, Radiance, Real, Renderer};

/// All rays that a pixel's color comes from.
#[derive(Clone, Debug)]
pub struct RayTree {
    /// In the order of the tree: a node, then its subtrees.
    pub nodes: Vec<Branch>,
    /// The pixel's color, linear.
    pub color: Color<Radiance>,
    /// How many rays there were.
    pub stats: Stats,
}

/// A node of the tree and the shadow rays that end there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Branch {
    /// Where a ray ends.
    pub node: RayNode,
    /// One for each light that the surface faces.
    pub shadows: Vec<Shadow>,
}

/// A ray between a light and a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shadow {
    /// The light's number.
    pub light: u16,
    /// What is left of the light; `None` if something opaque is between.
    pub left: Option<Color<Real>>,
}

/// Traces one pixel of a picture; `None` if it is outside.
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
        stats,
    })
}

/// Keeps what a renderer tells.
#[derive(Clone, Debug, Default)]
struct Collector {
    nodes: Vec<Branch>,
    /// Those of the node that comes next.
    shadows: Vec<Shadow>,
    stats: Stats,
}

impl Observer for Collector {
    fn ray(&mut self, kind: RayKind) {
        self.stats.ray(kind);
    }

    fn shadow(&mut self, light: u16, left: Option<Color<Real>>) {
        self.shadows.push(Shadow { light, left });
    }

    fn node(&mut self, node: &RayNode) {
        self.nodes.push(Branch {
            node: *node,
            shadows: std::mem::take(&mut self.shadows),
        });
    }
}

impl RayTree {
    /// The tree as text, the pixel's color and the number of rays. `name` may
    /// say more of an object than its number.
    pub fn draw(&self, name: impl Fn(u16) -> Option<String>) -> String {
        let mut text = String::new();
        for line in lines(&self.nodes, &name) {
            text.push_str(&line);
            text.push('\n');
        }
        // Writing to a string does not fail.
        let _ = self.sum(&mut text);
        text
    }

    fn sum(&self, text: &mut String) -> fmt::Result {
        let eight = Rgb888::from_radiance(self.color, Point::zero(), Output::default());
        let (r, g, b) = (eight.r(), eight.g(), eight.b());
        writeln!(text, "color: {}", numbers(self.color))?;
        writeln!(text, "8 bit: ({r}, {g}, {b})")?;
        let Stats {
            camera,
            reflected,
            transmitted,
            shadow,
            ..
        } = self.stats;
        let all = camera + reflected + transmitted + shadow;
        writeln!(
            text,
            "rays: {all}: {camera} camera, {reflected} reflected, {transmitted} transmitted, {shadow} shadow"
        )
    }
}

/// A tree line by line: its first node, and below that what the node's color
/// comes from.
fn lines(tree: &[Branch], name: &dyn Fn(u16) -> Option<String>) -> Vec<String> {
    let Some((root, rest)) = tree.split_first() else {
        return Vec::new();
    };
    let child = root.node.generation + 1;
    let subtrees = rest.chunk_by(|_, next| next.node.generation > child);
    let shadows = root.shadows.iter().map(|shadow| vec![shadow.to_string()]);
    let parts: Vec<_> = shadows
        .chain(subtrees.map(|subtree| lines(subtree, name)))
        .collect();
    let mut all = vec![head(&root.node, name)];
    for (index, part) in parts.iter().enumerate() {
        let (first, other) = if index + 1 == parts.len() {
            ("└─ ", "   ")
        } else {
            ("├─ ", "│  ")
        };
        let margins = std::iter::once(first).chain(std::iter::repeat(other));
        all.extend(
            part.iter()
                .zip(margins)
                .map(|(line, margin)| format!("{margin}{line}")),
        );
    }
    all
}

/// What a line says of a node itself.
fn head(node: &RayNode, name: &dyn Fn(u16) -> Option<String>) -> String {
    let kind = match node.kind {
        RayKind::Camera => 'E',
        RayKind::Reflected => 'R',
        RayKind::Transmitted => 'T',
        RayKind::Shadow => 'S',
    };
    let place = match node.object {
        None => "background".to_owned(),
        Some(object) => match name(object) {
            Some(name) => format!("object {object}, {name}"),
            None => format!("object {object}"),
        },
    };
    let side = if node.inside { " from inside" } else { "" };
    let (weight, local) = (numbers(node.weight), numbers(node.local));
    format!("{kind} {place}{side}: weight {weight}, local {local}")
}

impl fmt::Display for Shadow {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "S light {}: ", self.light)?;
        match self.left {
            None => f.write_str("blocked"),
            Some(left) if left == Color::gray(Real::ONE) => f.write_str("reached"),
            Some(left) => write!(f, "filtered by {}", numbers(left)),
        }
    }
}

/// A color; a gray as one number.
fn numbers<T: fmt::Display + PartialEq>(Color { r, g, b }: Color<T>) -> String {
    if r == g && g == b {
        format!("{r:.4}")
    } else {
        format!("({r:.4}, {g:.4}, {b:.4})")
    }
}
