//! Cylinders: clipped, thin and unbounded.

use super::case::{Case, FAR_AWAY, FROM_ABOVE, HUGE, INSIDE, TINY, TO_HORIZON};

const BASE: Case = Case::new(
    "cylinder",
    "origin = [0, -1, 0], radius = 1, y = [0, 2]",
    [0.2, 0.3, 0.1],
);

/// Cylinder without end.
const UNBOUNDED: &str = "origin = [0, 5, 0], radius = 1";

pub(crate) const CASES: &[Case] = &[
    BASE.case("front", [100.0, 101.0, 91.0]),
    BASE.case("open end seen from above", [99.0, 101.0, 96.0])
        .camera("eye = [1, 4, 2], look_at = [0, 0, 0], fovy_deg = 33"),
    BASE.case("seen down the axis", [102.0, 103.0, 100.0])
        .camera(FROM_ABOVE),
    BASE.case("seen down the wall", [102.0, 103.0, 96.0])
        .camera("eye = [0.9, 9, 0], look_at = [0.9, 0, 0], up = [0, 0, -1], fovy_deg = 6")
        .shape("origin = [0, -9, 0], radius = 1, y = [0, 17]"),
    BASE.case("silhouette", [100.0, 99.0, 89.0])
        .camera("eye = [1, 0, 5], look_at = [1, 0, 0], fovy_deg = 1"),
    BASE.case("grazing rays", [102.0, 103.0, 100.0])
        .camera("eye = [1.0001, 3, 0], look_at = [1, 0, -0.3], fovy_deg = 5"),
    BASE.case("seen from inside", [97.0, 93.0, 95.0])
        .camera(INSIDE),
    BASE.case("rim", [95.0, 92.0, 89.0])
        .camera("eye = [0.2, 1.3, 2], look_at = [0, 1, 0.95], fovy_deg = 10"),
    BASE.case("clipped far from its origin", [100.0, 101.0, 91.0])
        .shape("origin = [0, -1001, 0], radius = 1, y = [1000, 1002]"),
    BASE.case("seen from far away", [101.0, 102.0, 97.0])
        .camera(FAR_AWAY),
    BASE.case("tiny scene", [99.0, 101.0, 95.0])
        .camera(TINY)
        .shape("origin = [0, -0.001, 0], radius = 0.001, y = [0, 0.002]"),
    BASE.case("huge scene", [99.0, 98.0, 93.0])
        .camera(HUGE)
        .lights([30000.0, 40000.0, 50000.0], [2000.0, 3000.0, 1000.0])
        .shape("origin = [0, -10000, 0], radius = 10000, y = [0, 20000]"),
    BASE.case("thin wire", [102.0, 103.0, 99.0])
        .camera("eye = [0.1, 0.2, 1], look_at = [0, 0, 0], fovy_deg = 4")
        .second_light([0.0005, 0.3, 0.0])
        .shape("origin = [0, -1, 0], radius = 0.001, y = [0, 2]"),
    BASE.case("ring", [102.0, 103.0, 102.0])
        .second_light([0.2, 0.0, 0.1])
        .shape("origin = [0, 0, 0], radius = 1, y = [-0.03, 0.03]"),
    BASE.case("checkered", [100.0, 101.0, 97.0]).checkered("xy"),
    BASE.case("on a floor", [98.0, 95.0, 92.0]).floor(-1.0),
    BASE.case("in front of a mirror", [99.0, 98.0, 93.0])
        .mirror(-1.5),
    BASE.case("unbounded", [100.0, 102.0, 88.0])
        .shape(UNBOUNDED),
    BASE.case("unbounded, seen from inside", [99.0, 88.0, 97.0])
        .camera(INSIDE)
        .shape(UNBOUNDED),
    BASE.case("unbounded, seen up the axis", [101.0, 87.0, 99.0])
        .camera("eye = [0, 0, 0], look_at = [0, 1, 0], up = [0, 0, -1], fovy_deg = 60")
        .shape(UNBOUNDED),
    BASE.case("unbounded, seen up along the outside", [99.0, 99.0, 94.0])
        .camera("eye = [0, 0, 2], look_at = [0, 9, 0], fovy_deg = 60")
        .shape(UNBOUNDED),
    BASE.case("unbounded, seen in a mirror", [98.0, 97.0, 91.0])
        .camera("eye = [0, 0, 2.5], look_at = [0, 9, -9], fovy_deg = 40")
        .shape(UNBOUNDED)
        .mirror(-3.0),
    BASE.case("unbounded, on a floor", [98.0, 98.0, 96.0])
        .camera("eye = [2, 2, 6], look_at = [0, 0, -8], fovy_deg = 50")
        .shape("origin = [0, 0, -3], radius = 0.5")
        .floor(0.0),
    BASE.case("unbounded, far reflection", [97.0, 98.0, 93.0])
        .camera(TO_HORIZON)
        .shape("origin = [0, 0, -9], radius = 2")
        .floor(0.0),
    BASE.case("unbounded, seen in a far mirror", [98.0, 98.0, 95.0])
        .camera(TO_HORIZON)
        .shape("origin = [3, 0, -3], radius = 0.5")
        .mirror(-60.0),
    BASE.case("unbounded, checkered", [100.0, 102.0, 96.0])
        .shape(UNBOUNDED)
        .checkered("xy"),
];
