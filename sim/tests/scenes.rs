//! The scenes in scenes/: each loads, and those that were copied from a reference scene still have
//! its values.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use whitted::{Object, Real, Shape};
use whitted_sim::scene_file::{self, Buffer, SceneFile};

fn project() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn scene(name: &str) -> Result<SceneFile, Box<dyn Error>> {
    Ok(scene_file::load(
        project().join("scenes").join(name).with_extension("toml"),
    )?)
}

fn reference(name: &str) -> Result<SceneFile, Box<dyn Error>> {
    let folder = project().join("tests/reference/scenes");
    Ok(scene_file::load(folder.join(name).with_extension("toml"))?)
}

/// Replaces the ratio 0.333333333 by 1/3. The reference files have the former, but their pictures
/// were rendered with the latter.
fn use_exact_ratio(object: &mut Object) {
    if let Shape::Sphereflake { ratio, .. } = &mut object.shape {
        assert_eq!(*ratio, Real::lit("0.333333333"));
        *ratio = Shape::FLAKE_RATIO;
    }
}

#[test]
fn every_scene_loads_and_prepares() -> Result<(), Box<dyn Error>> {
    let mut count = 0;
    for entry in fs::read_dir(project().join("scenes"))? {
        let file = scene_file::load(entry?.path())?;
        file.prepare(&mut Box::new(Buffer::new()))?;
        assert!(file.title.is_some(), "{file:?}");
        count += 1;
    }
    assert!(count >= 24);
    Ok(())
}

#[test]
fn scenes_have_the_values_of_their_references() -> Result<(), Box<dyn Error>> {
    let pairs = [
        ("whitted", "01_whitted"),
        ("still_life", "02_still_life"),
        ("phong_terms", "03_phong_terms"),
        ("shininess_phong", "04_shininess_phong"),
        ("shininess_blinn", "05_shininess_blinn"),
        ("cylinders", "06_cylinder"),
        ("cones", "07_cone"),
        ("paraboloids", "08_paraboloid"),
        ("ellipsoids", "09_ellipsoid"),
        ("mirrors", "10_mirrors_d6"),
        ("total_reflection", "11b_tir_ellipsoids"),
        ("filters", "12_filters"),
        ("sphereflake_1", "13_flake_d1"),
        ("sphereflake_3", "13_flake_d3"),
        ("sphereflake", "13_flake_d6"),
        ("tinted_diamond", "t10_tir_kt_kr"),
        ("glass_indices", "11_glass_indices"),
        ("four_spheres", "ftb"),
        ("kt_plus_kd", "t06_kt_plus_kd"),
        ("emission_ambient", "t13_emission_ambient"),
        ("camera_inside_glass", "t15_camera_inside_glass"),
        ("backlit_phong", "t18_backlit_phong"),
        ("backlit_blinn", "t19_backlit_blinn"),
    ];
    for (name, original) in pairs {
        let (scene, mut original) = (scene(name)?, reference(original)?);
        original.objects.iter_mut().for_each(use_exact_ratio);
        assert_eq!(scene.objects, original.objects, "{name}");
        assert_eq!(scene.lights, original.lights, "{name}");
        assert_eq!(scene.materials, original.materials, "{name}");
        // The settings have no lists, so their debug output has every value.
        let settings = [scene.settings, original.settings];
        let [actual, expected] = settings.map(|settings| format!("{settings:?}"));
        assert_eq!(actual, expected, "{name}");
    }
    Ok(())
}
