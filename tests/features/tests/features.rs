//! Every set of features draws the same bits, and names a feature that a scene needs.

use feature_tests::{ELLIPSOID, GLASS_SPHERE, SPHEREFLAKE, SPHERES_AND_PLANES, checksum};
use whitted::scene::SceneProblem;
use whitted::{DecodeError, Scene, SceneBuffer, SceneError};

type Buffer = SceneBuffer<4, 1, 2>;

/// Scenes that need a feature: its name, whether it is on, and the compiled scene.
const CASES: [(&str, bool, &Scene<'static>, &[u8]); 3] = [
    (
        "glass",
        cfg!(feature = "glass"),
        &GLASS_SPHERE,
        include_bytes!("glass.bin"),
    ),
    (
        "quadrics",
        cfg!(feature = "quadrics"),
        &ELLIPSOID,
        include_bytes!("quadrics.bin"),
    ),
    (
        "sphereflake",
        cfg!(feature = "sphereflake"),
        &SPHEREFLAKE,
        include_bytes!("sphereflake.bin"),
    ),
];

#[test]
fn spheres_and_planes_have_the_same_bits_with_any_features() -> Result<(), SceneError> {
    let mut buffer = Buffer::new();
    let scene = buffer.prepare(&SPHERES_AND_PLANES)?;
    assert_eq!(checksum(&scene), 0xc951_17f1);
    Ok(())
}

#[test]
fn preparing_names_the_missing_feature() {
    for (feature, is_on, scene, _) in CASES {
        let mut buffer = Buffer::new();
        let prepared = buffer.prepare(scene);
        match prepared {
            Ok(_) => assert!(is_on, "{feature}"),
            Err(error) => {
                assert!(!is_on, "{feature}: {error}");
                assert_eq!(error.problem, SceneProblem::MissingFeature(feature));
                assert!(error.to_string().contains(feature), "{error}");
            }
        }
    }
}

#[test]
fn decoding_names_the_missing_feature() {
    for (feature, is_on, scene, compiled) in CASES {
        let mut buffer = Buffer::new();
        let decoded = buffer.decode(compiled);
        match decoded {
            Ok(decoded) => {
                assert!(is_on, "{feature}");
                let mut buffer = Buffer::new();
                let prepared = buffer.prepare(scene).map(|scene| checksum(&scene));
                assert_eq!(Ok(checksum(&decoded)), prepared, "{feature}");
            }
            Err(error) => {
                assert!(!is_on, "{feature}: {error}");
                assert_eq!(error, DecodeError::MissingFeature(feature));
            }
        }
    }
}
