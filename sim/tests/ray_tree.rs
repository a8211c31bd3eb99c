//! Ray trees of pixels.

use std::error::Error;

use embedded_graphics_core::geometry::Size;
use whitted::observer::RayKind;
use whitted_sim::ray_tree;
use whitted_sim::scene_file::{self, Buffer};

/// Along the z axis stand a light, the camera, a glass sphere, a mirror, and a second light behind
/// the mirror. The only pixel looks along the axis, 0.001 beside it.
const SCENE: &str = r#"
max_depth = 2
min_weight = 0
background = [0, 0, 1]
camera = { eye = [0.001, 0, 10], look_at = [0.001, 0, 0], fovy_deg = 30 }

[[lights]]
position = [0, 0, 20]
color = [1, 1, 1]

[[lights]]
position = [0, 0, -20]
color = [1, 1, 1]

[materials.glass]
kd = [0.25, 0.25, 0.25]
kr = [0.25, 0.25, 0.25]
kt = [0.5, 0.5, 0.25]
ior = "glass"

[materials.mirror]
kd = [0, 0.5, 0]
kr = [1, 1, 1]

[[objects]]
type = "sphere"
center = [0, 0, 0]
radius = 1
material = "glass"

[[objects]]
type = "plane"
normal = [0, 0, 1]
point = [0, 0, -3]
bounds = { x = [-2, 2] }
checker = { size = 4, axes = "xy", materials = ["mirror", "mirror"] }
"#;

const TREE: &str = r#"C object 0, sphere "glass": weight 1.0000, local 0.2500
├─ S light 0: visible
├─ R background: weight 0.2500, local (0.0000, 0.0000, 1.0000)
└─ T object 0, sphere "glass" from inside: weight (0.5000, 0.5000, 0.2500), local (0.1250, 0.1250, 0.0625)
   ├─ S light 0: filtered by (0.5000, 0.5000, 0.2500)
   ├─ R object 0, sphere "glass" from inside: weight (0.1250, 0.1250, 0.0625), local 0.0000
   │  └─ S light 1: blocked
   └─ T object 1, plane "mirror" or "mirror": weight (0.2500, 0.2500, 0.0625), local (0.0000, 0.1250, 0.0000)
      └─ S light 0: filtered by (0.2500, 0.2500, 0.0625)
color: (0.3125, 0.3438, 0.5156)
8 bit: (80, 88, 131)
rays: 9: 1 camera, 2 reflected, 2 transmitted, 4 shadow
"#;

#[test]
fn formats_the_tree_of_a_pixel() -> Result<(), Box<dyn Error>> {
    let file = scene_file::parse("tree.toml", SCENE)?;
    let mut buffer = Box::new(Buffer::new());
    let scene = file.prepare(&mut buffer)?;
    let tree = ray_tree::trace(&scene, Size::new(1, 1), [0, 0]).ok_or("a tree")?;
    let text = tree.draw(|object| file.describe(object));
    assert_eq!(text, TREE, "\n{text}");
    let unnamed = tree.draw(|_| None);
    assert!(unnamed.starts_with("C object 0: weight"), "{unnamed}");
    Ok(())
}

/// The sum of weight times local color over all nodes is the pixel's color.
#[test]
fn tree_adds_up_to_the_rendered_color() -> Result<(), Box<dyn Error>> {
    let file = scene_file::parse("tree.toml", SCENE)?;
    let mut buffer = Box::new(Buffer::new());
    let scene = file.prepare(&mut buffer)?;
    let size = Size::new(9, 7);
    let mut renderer = whitted::Renderer::new(&scene, size);
    for y in 0..size.height {
        let line: Vec<_> = renderer.line(y).collect();
        for (x, color) in (0..).zip(line) {
            let tree = ray_tree::trace(&scene, size, [x, y]).ok_or("a tree")?;
            assert_eq!(tree.color, color);
            let kinds = tree.nodes.iter().map(|branch| branch.node.kind);
            assert_eq!(kinds.filter(|kind| *kind == RayKind::Camera).count(), 1);
            let sum = tree.nodes.iter().map(|branch| {
                branch.node.weight.r.to_num::<f64>() * branch.node.local.r.to_num::<f64>()
            });
            assert!((sum.sum::<f64>() - color.r.to_num::<f64>()).abs() < 2e-4);
        }
    }
    Ok(())
}

#[test]
fn pixel_outside_the_picture_has_no_tree() -> Result<(), Box<dyn Error>> {
    let file = scene_file::parse("tree.toml", SCENE)?;
    let mut buffer = Box::new(Buffer::new());
    let scene = file.prepare(&mut buffer)?;
    for pixel in [[2, 0], [0, 3], [u32::MAX, u32::MAX]] {
        assert!(ray_tree::trace(&scene, Size::new(2, 3), pixel).is_none());
    }
    Ok(())
}
