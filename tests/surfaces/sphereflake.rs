//! Sphereflakes of several depths, ratios and orientations.

use super::case::{Case, FAR_AWAY, HUGE, TINY};

const BASE: Case = Case::new(
    "sphereflake",
    "center = [0, 0, 0], radius = 0.6, depth = 2",
    [0.1, 0.15, 0.05],
);

/// Sphereflake of ratio 0.5, in which small spheres of different parents coincide.
const COINCIDENT: &str = "center = [0, 0, 0], radius = 0.4, depth = 3, ratio = 0.5";

pub(crate) const CASES: &[Case] = &[
    BASE.case("front", [101.0, 98.0, 91.0]),
    BASE.case("depth 0", [100.0, 101.0, 90.0])
        .shape("center = [0, 0, 0], radius = 1, depth = 0"),
    BASE.case("depth 1", [101.0, 101.0, 92.0])
        .shape("center = [0, 0, 0], radius = 0.6, depth = 1"),
    // Reflections among small spheres amplify rounding errors, so these cases trace two bounces.
    BASE.case("depth 3", [101.0, 100.0, 97.0])
        .shape("center = [0, 0, 0], radius = 0.6, depth = 3")
        .max_depth(2),
    BASE.case("depth 4", [101.0, 99.0, 97.0])
        .shape("center = [0, 0, 0], radius = 0.6, depth = 4")
        .max_depth(2),
    BASE.case("ratio 0.1", [101.0, 101.0, 92.0])
        .shape("center = [0, 0, 0], radius = 0.8, depth = 3, ratio = 0.1"),
    BASE.case("ratio 0.45", [101.0, 101.0, 97.0])
        .shape("center = [0, 0, 0], radius = 0.4, depth = 3, ratio = 0.45")
        .max_depth(2),
    // Rounding decides which of two coincident glass spheres a ray hits first, so glass gets a loose limit.
    BASE.case("ratio 0.5, small spheres coincide", [101.0, 99.0, 60.0])
        .shape(COINCIDENT)
        .outliers([0, 0, 8]),
    BASE.case("coincident spheres in close-up", [99.0, 100.0, 97.0])
        .camera("eye = [0.5, 0.1, 1.2], look_at = [0.1, -0.15, 0.6], fovy_deg = 20")
        .shape(COINCIDENT)
        .max_depth(1),
    BASE.case("rotated", [101.0, 100.0, 97.0])
        .shape("center = [0, 0, 0], radius = 0.6, depth = 3, frame = [[0.6, 0, 0.8], [0.64, 0.6, -0.48], [-0.48, 0.8, 0.36]]")
        .max_depth(2),
    BASE.case("rotated, ratio 0.45", [101.0, 99.0, 98.0])
        .shape("center = [0, 0, 0], radius = 0.4, depth = 3, ratio = 0.45, frame = [[0.6, 0, 0.8], [0.64, 0.6, -0.48], [-0.48, 0.8, 0.36]]")
        .max_depth(2),
    BASE.case("seen down an axis", [101.0, 93.0, 89.0])
        .camera("eye = [0, 9, 0], look_at = [0, 0, 0], up = [0, 0, -1], fovy_deg = 12"),
    BASE.case("tangent point of two spheres", [100.0, 91.0, 85.0])
        .camera("eye = [0.6, 0.1, 0.5], look_at = [0.6, 0, 0], fovy_deg = 10"),
    BASE.case("smallest spheres in close-up", [98.0, 99.0, 98.0])
        .camera("eye = [0.95, 0.8, 0.5], look_at = [0.5, 0.65, 0], fovy_deg = 5")
        .shape("center = [0, 0, 0], radius = 0.6, depth = 4")
        .max_depth(1),
    BASE.case("grazing rays", [99.0, 96.0, 86.0])
        .camera("eye = [0.05, 0.602, 3], look_at = [0, 0.6, 0], fovy_deg = 4"),
    BASE.case("seen from inside", [99.0, 88.0, 90.0])
        .camera("eye = [0.2, 0.1, 0.2], look_at = [1, 0.3, -1], fovy_deg = 90"),
    BASE.case("seen from inside a child", [99.0, 88.0, 92.0])
        .camera("eye = [0.75, 0.05, 0.02], look_at = [1, 0.3, -1], fovy_deg = 90")
        .second_light([0.85, 0.1, 0.05]),
    BASE.case("seen from among the children", [96.0, 97.0, 94.0])
        .camera("eye = [0.4, 0.75, 0.1], look_at = [0, 0.6, -0.3], fovy_deg = 90")
        .second_light([0.3, 0.9, 0.3])
        .shape("center = [0, 0, 0], radius = 0.6, depth = 3")
        .max_depth(2),
    BASE.case("seen from far away", [102.0, 92.0, 84.0])
        .camera(FAR_AWAY),
    BASE.case("tiny scene", [97.0, 91.0, 97.0])
        .camera(TINY)
        .shape("center = [0, 0, 0], radius = 0.001, depth = 1")
        .max_depth(2),
    BASE.case("huge scene", [101.0, 100.0, 92.0])
        .camera(HUGE)
        .lights([30000.0, 40000.0, 50000.0], [1000.0, 1500.0, 500.0])
        .shape("center = [0, 0, 0], radius = 6000, depth = 2"),
    BASE.case("checkered", [101.0, 100.0, 97.0])
        .checkered("xz"),
    BASE.case("on a floor", [98.0, 95.0, 91.0])
        .floor(-0.9),
    BASE.case("in front of a mirror", [100.0, 95.0, 92.0])
        .mirror(-1.5),
];
