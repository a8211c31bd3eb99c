//! Text output of a ray tree.

use std::fmt::{self, Write};

use embedded_graphics_core::geometry::Point;
use embedded_graphics_core::pixelcolor::{Rgb888, RgbColor};
use whitted::observer::{RayKind, RayNode, Stats};
use whitted::render::DisplayColor;
use whitted::{Color, Real};

use super::{RayTree, ShadowRay, TreeNode};

impl RayTree {
    /// Formats the ray tree, the pixel's color, and the number of rays. `describe` receives the
    /// index of an object, and returns a description of the object or `None`.
    pub fn draw(&self, describe: impl Fn(u16) -> Option<String>) -> String {
        let mut text = String::new();
        for line in tree_lines(&self.nodes, &describe) {
            text.push_str(&line);
            text.push('\n');
        }
        // Writing to a string does not fail.
        let _ = self.write_summary(&mut text);
        text
    }

    fn write_summary(&self, text: &mut String) -> fmt::Result {
        let rgb = Rgb888::from_radiance(self.color, Point::zero(), self.output);
        let (r, g, b) = (rgb.r(), rgb.g(), rgb.b());
        writeln!(text, "color: {}", format_color(self.color))?;
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

/// Formats a ray tree as lines. The first line is the root. Its shadow rays and subtrees follow and
/// are indented.
fn tree_lines(tree: &[TreeNode], describe: &dyn Fn(u16) -> Option<String>) -> Vec<String> {
    let Some((root, rest)) = tree.split_first() else {
        return Vec::new();
    };
    let child = root.node.generation + 1;
    let subtrees = rest.chunk_by(|_, next| next.node.generation > child);
    let shadows = root.shadows.iter().map(|shadow| vec![shadow.to_string()]);
    let parts: Vec<_> = shadows
        .chain(subtrees.map(|subtree| tree_lines(subtree, describe)))
        .collect();
    let mut lines = vec![node_line(&root.node, describe)];
    for (index, part) in parts.iter().enumerate() {
        let (first, other) = if index + 1 == parts.len() {
            ("└─ ", "   ")
        } else {
            ("├─ ", "│  ")
        };
        let margins = std::iter::once(first).chain(std::iter::repeat(other));
        let indented = part.iter().zip(margins);
        lines.extend(indented.map(|(line, margin)| format!("{margin}{line}")));
    }
    lines
}

fn node_line(node: &RayNode, describe: &dyn Fn(u16) -> Option<String>) -> String {
    let kind = match node.kind {
        RayKind::Camera => 'C',
        RayKind::Reflected => 'R',
        RayKind::Transmitted => 'T',
        RayKind::Shadow => 'S',
    };
    let hit = match node.object {
        None => "background".to_owned(),
        Some(object) => match describe(object) {
            Some(description) => format!("object {object}, {description}"),
            None => format!("object {object}"),
        },
    };
    let side = if node.inside { " from inside" } else { "" };
    let (weight, local) = (format_color(node.weight), format_color(node.local));
    format!("{kind} {hit}{side}: weight {weight}, local {local}")
}

impl fmt::Display for ShadowRay {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "S light {}: ", self.light)?;
        match self.transmittance {
            None => f.write_str("blocked"),
            Some(all) if all == Color::gray(Real::ONE) => f.write_str("visible"),
            Some(part) => write!(f, "filtered by {}", format_color(part)),
        }
    }
}

/// Formats a color with four decimals. A gray color is written as one number.
fn format_color<T: fmt::Display + PartialEq>(Color { r, g, b }: Color<T>) -> String {
    if r == g && g == b {
        format!("{r:.4}")
    } else {
        format!("({r:.4}, {g:.4}, {b:.4})")
    }
}
