//! Paraboloids, in scenes from 0.05 to a million units across.

use super::case::{Case, FAR_AWAY, FROM_ABOVE, FROM_BELOW, INSIDE};

const BASE: Case = Case::new(
    "paraboloid",
    "origin = [0, -1, 0], y = [0, 2]",
    [0.2, 0.4, 0.1],
);

pub(crate) const CASES: &[Case] = &[
    BASE.case("front", [100.0, 102.0, 93.0]),
    BASE.case("open end seen from above", [97.0, 94.0, 94.0])
        .camera("eye = [1, 5, 2], look_at = [0, 0, 0], fovy_deg = 33"),
    BASE.case("seen down the axis", [98.0, 95.0, 94.0])
        .camera(FROM_ABOVE),
    BASE.case("seen up the axis", [100.0, 98.0, 99.0])
        .camera(FROM_BELOW),
    BASE.case("rim, rays parallel to the axis", [101.0, 95.0, 95.0])
        .camera("eye = [1.414, 9, 0], look_at = [1.414, 0, 0], up = [0, 0, -1], fovy_deg = 2"),
    BASE.case("vertex", [101.0, 102.0, 91.0])
        .camera("eye = [0.1, -1.2, 0.5], look_at = [0, -1, 0], fovy_deg = 10"),
    BASE.case("grazing rays", [101.0, 96.0, 98.0])
        .camera("eye = [1.001, -2, 0], look_at = [1.0001, 0, -0.05], fovy_deg = 5"),
    BASE.case("silhouette", [101.0, 102.0, 90.0])
        .camera("eye = [1, 0, 5], look_at = [1, 0, 0], fovy_deg = 2"),
    BASE.case("seen from inside", [97.0, 98.0, 96.0])
        .camera(INSIDE),
    BASE.case("rim", [96.0, 101.0, 92.0])
        .camera("eye = [0.2, 1.3, 3], look_at = [0, 1, 1.4], fovy_deg = 10"),
    BASE.case("ring", [100.0, 102.0, 97.0])
        .shape("origin = [0, -1, 0], y = [1, 1.5]"),
    BASE.case("clipped far from its origin", [100.0, 101.0, 100.0])
        .camera("eye = [10, 3, 60], look_at = [0, 0, 0], fovy_deg = 60")
        .shape("origin = [0, -1001, 0], y = [1000, 1002]"),
    BASE.case("seen from far away", [101.0, 102.0, 98.0])
        .camera(FAR_AWAY),
    BASE.case("scene of size 0.05", [96.0, 98.0, 95.0])
        .camera("eye = [0.05, 0.06, 0.2], look_at = [0, 0, 0], fovy_deg = 33")
        .lights([0.15, 0.2, 0.25], [0.001, 0.045, 0.0005])
        .shape("origin = [0, -0.025, 0], y = [0, 0.05]"),
    BASE.case("scene of size 10", [101.0, 102.0, 93.0])
        .camera("eye = [10, 12, 40], look_at = [0, 0, 0], fovy_deg = 15")
        .lights([30.0, 40.0, 50.0], [0.2, 9.0, 0.1])
        .shape("origin = [0, -5, 0], y = [0, 10]"),
    BASE.case("scene of size 10,000", [100.0, 101.0, 90.0])
        .camera("eye = [200, 100, 400], look_at = [0, 0, 0], fovy_deg = 33")
        .lights([30000.0, 40000.0, 50000.0], [200.0, 9000.0, 100.0])
        .shape("origin = [0, -5000, 0], y = [0, 10000]"),
    BASE.case("scene of size 1,000,000", [99.0, 100.0, 88.0])
        .camera("eye = [1500, 400, 2500], look_at = [0, 0, 0], fovy_deg = 33")
        .lights([3000.0, 4000.0, 5000.0], [2.0, 3000.0, 1.0])
        .shape("origin = [0, -500000, 0], y = [0, 1000000]"),
    BASE.case("tiny scene", [102.0, 102.0, 101.0])
        .camera("eye = [0.03, 0.015, 0.05], look_at = [0, 0, 0], fovy_deg = 33")
        .second_light([0.0001, 0.0001, 0.0])
        .shape("origin = [0, 0, 0], y = [0, 0.0001]"),
    BASE.case("checkered", [101.0, 102.0, 98.0]).checkered("xz"),
    BASE.case("on a floor", [99.0, 95.0, 93.0]).floor(-1.0),
    BASE.case("in front of a mirror", [99.0, 98.0, 94.0])
        .mirror(-1.5),
];
