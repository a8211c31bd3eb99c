//! Reads a scene file that has every key.

use std::error::Error;

use whitted::scene::{Axis, ClipBox, SpecularModel, Transfer};
use whitted::{Background, Color, Light, MaterialId, Real, Shape, Texture, vec3};
use whitted_sim::scene_file;

use crate::real;

const FULL: &str = r##"
title = "All keys"
max_depth = 7
min_weight = 0.25
shading = "blinn-phong"
ambient = [0.5, 1, 2]
background = { horizon = [0.5, 0.5, 0.5], zenith = "#0000ff" }
transfer = "srgb"

[camera]
eye = [1, 2, 3]
look_at = [-0.5, 1e1, 1_000.25]
up = [0, 0, 1]
fovy_deg = 0x20

[[lights]]
position = [1, 2, 3]
color = "#c04020"

[[lights]]
position = [3, 2, 1]
diffuse = [1, 0, 0]
specular = [0, 1, 0]

[materials.second-by-letter]
kt = [1, 1, 1]
ior = "diamond"

[materials.first-by-letter]
ka = [0.5, 0, 0]
kd = [0, 0.5, 0]
ks = [0, 0, 0.5]
shininess = 12
kr = [0.25, 0, 0]
kt = [0, 0.25, 0]
ior = 1.5
le = [0, 0, 0.25]
model = "phong"

[[objects]]
type = "plane"
normal = [0, 1, 0]
point = [0, -1, 0]
bounds = { x = [-5, 5], z = [-4, 4] }
checker = { size = 2, axes = "zx", materials = ["first-by-letter", "second-by-letter"] }

[[objects]]
type = "sphere"
center = [0, 1, 0]
radius = 0.5
material = "first-by-letter"
"##;

fn color(r: &str, g: &str, b: &str) -> Color<Real> {
    Color::new(real(r), real(g), real(b))
}

#[test]
fn reads_every_key() -> Result<(), Box<dyn Error>> {
    let file = scene_file::parse("full.toml", FULL)?;
    let scene = file.scene();
    assert_eq!(file.title.as_deref(), Some("All keys"));
    assert_eq!((scene.max_depth, scene.min_weight), (7, real("0.25")));
    assert_eq!(scene.shading, SpecularModel::BlinnPhong);
    assert_eq!(scene.transfer, Transfer::Srgb);
    assert_eq!(scene.ambient, color("0.5", "1", "2"));
    let (horizon, zenith) = (Color::gray(real("0.5")), color("0", "0", "1"));
    assert_eq!(scene.background, Background::Gradient { horizon, zenith });
    assert_eq!(scene.camera.eye, vec3!(1, 2, 3));
    assert_eq!(scene.camera.look_at, vec3!(-0.5, 10, 1000.25));
    assert_eq!(scene.camera.up, vec3!(0, 0, 1));
    assert_eq!(scene.camera.fovy_deg, real("32"));
    let lights = [
        Light::point(vec3!(1, 2, 3), Color::srgb(0xc0, 0x40, 0x20)),
        Light {
            position: vec3!(3, 2, 1),
            diffuse: color("1", "0", "0"),
            specular: color("0", "1", "0"),
        },
    ];
    assert_eq!(scene.lights, lights);
    Ok(())
}

#[test]
fn numbers_materials_in_the_order_of_the_file() -> Result<(), Box<dyn Error>> {
    let file = scene_file::parse("full.toml", FULL)?;
    assert_eq!(file.material_names, ["second-by-letter", "first-by-letter"]);
    let [clear, mixed] = file.materials[..] else {
        return Err("two materials".into());
    };
    assert_eq!((clear.ior, clear.shading), (real("2.417"), None));
    assert_eq!(
        (mixed.ka, mixed.kd),
        (color("0.5", "0", "0"), color("0", "0.5", "0"))
    );
    assert_eq!(
        (mixed.ks, mixed.le),
        (color("0", "0", "0.5"), color("0", "0", "0.25"))
    );
    assert_eq!(
        (mixed.kr, mixed.kt),
        (color("0.25", "0", "0"), color("0", "0.25", "0"))
    );
    assert_eq!((mixed.shininess, mixed.ior), (real("12"), real("1.5")));
    assert_eq!(mixed.shading, Some(SpecularModel::Phong));
    Ok(())
}

#[test]
fn keeps_the_order_of_objects() -> Result<(), Box<dyn Error>> {
    let file = scene_file::parse("full.toml", FULL)?;
    let [floor, ball] = file.objects[..] else {
        return Err("two objects".into());
    };
    let bounds = ClipBox {
        x: Some([real("-5"), real("5")]),
        y: None,
        z: Some([real("-4"), real("4")]),
    };
    let (normal, point) = (vec3!(0, 1, 0), vec3!(0, -1, 0));
    assert_eq!(
        floor.shape,
        Shape::Plane {
            normal,
            point,
            bounds
        }
    );
    let checker = Texture::Checker {
        size: real("2"),
        axes: [Axis::Z, Axis::X],
        materials: [MaterialId(1), MaterialId(0)],
    };
    assert_eq!(floor.texture, checker);
    let (center, radius) = (vec3!(0, 1, 0), real("0.5"));
    assert_eq!(ball.shape, Shape::Sphere { center, radius });
    assert_eq!(ball.texture, Texture::Uniform(MaterialId(1)));
    Ok(())
}
