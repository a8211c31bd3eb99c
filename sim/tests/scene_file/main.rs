//! Reads scene files into scenes.

mod keys;
mod shapes;

use std::error::Error;

use whitted::Real;
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
fn suggests_names_for_misspelled_ones() {
    let names = ["sphere", "plane", "blinn-phong", "kd"];
    assert_eq!(nearest("shpere", names), Some("sphere"));
    assert_eq!(nearest("Plane", names), Some("plane"));
    assert_eq!(nearest("blinn", names), Some("blinn-phong"));
    assert_eq!(nearest("torus", names), None);
    assert_eq!(nearest("", names), None);
}
