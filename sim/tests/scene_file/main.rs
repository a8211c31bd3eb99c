//! Reads scene files into scenes.

mod keys;
mod shapes;

use std::error::Error;

use whitted::{Background, Color, Real};
use whitted_sim::scene_file::{self, nearest};

const CAMERA: &str = "camera = { eye = [0, 0, 1], look_at = [0, 0, 0], fovy_deg = 33 }\n";

fn real(literal: &str) -> Real {
    literal.parse().unwrap_or_default()
}

#[test]
fn only_the_camera_is_required() -> Result<(), Box<dyn Error>> {
    let file = scene_file::parse("least.toml", CAMERA)?;
    let scene = file.scene();
    let default = whitted::Scene::new(scene.camera);
    assert_eq!(format!("{scene:?}"), format!("{default:?}"));
    Ok(())
}

#[test]
fn rounds_decimals_to_nearest() -> Result<(), Box<dyn Error>> {
    for decimal in [
        "0.1",
        "-0.3",
        "0.0039215686",
        "2147483647.75",
        "1.3e-3",
        "1e-12",
    ] {
        let file = scene_file::parse("n.toml", &format!("min_weight = {decimal}\n{CAMERA}"))?;
        assert_eq!(file.scene().min_weight, real(decimal), "{decimal}");
    }
    Ok(())
}

#[test]
fn one_hexadecimal_digit_stands_for_two() -> Result<(), Box<dyn Error>> {
    let background = |color: &str| {
        let text = format!("background = \"{color}\"\n{CAMERA}");
        Ok::<_, Box<dyn Error>>(scene_file::parse("c.toml", &text)?.scene().background)
    };
    let orange = Background::Solid(Color::srgb(0xff, 0xaa, 0x00));
    for color in ["#fa0", "#FA0", "#ffaa00", "#FFaa00"] {
        assert_eq!(background(color)?, orange, "{color}");
    }
    Ok(())
}

#[test]
fn suggests_names_for_misspelled_ones() {
    let names = ["sphere", "plane", "blinn-phong", "kd"];
    assert_eq!(nearest("shpere", names), Some("sphere"));
    assert_eq!(nearest("Plane", names), Some("plane"));
    assert_eq!(nearest("blinn", names), Some("blinn-phong"));
    assert_eq!(nearest("torus", names), None);
    assert_eq!(nearest("", names), None);
}
