//! The project's scenes: each loads, and is in numbers the reference that it
//! is an edited copy of.

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

/// The references write 0.333333333 for a third, and are pictures of a third.
fn exact(object: &mut Object) {
    if let Shape::Sphereflake { ratio, .. } = &mut object.shape {
        assert_eq!(*ratio, Real::lit("0.333333333"));
        *ratio = Shape::FLAKE_RATIO;
    }
}

#[test]
fn every_scene_can_be_rendered() -> Result<(), Box<dyn Error>> {
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
fn scenes_are_the_references_in_numbers() -> Result<(), Box<dyn Error>> {
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
        original.objects.iter_mut().for_each(exact);
        assert_eq!(scene.objects, original.objects, "{name}");
        assert_eq!(scene.lights, original.lights, "{name}");
        assert_eq!(scene.materials, original.materials, "{name}");
        // The rest has no lists, so its Debug form tells all.
        let settings = [scene.settings, original.settings];
        let [ours, theirs] = settings.map(|settings| format!("{settings:?}"));
        assert_eq!(ours, theirs, "{name}");
    }
    Ok(())
}
