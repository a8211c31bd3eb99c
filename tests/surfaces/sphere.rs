//! Spheres: unit size, tiny, huge and far from the origin.

use super::case::{Case, FAR_AWAY, HUGE, INSIDE, TINY};

const BASE: Case = Case::new("sphere", "center = [0, 0, 0], radius = 1", [0.2, 0.3, 0.1]);

pub(crate) const CASES: &[Case] = &[
    BASE.case("front", [100.0, 101.0, 90.0]),
    BASE.case("grazing rays", [99.0, 98.0, 90.0])
        .camera("eye = [0, 1.0001, 3], look_at = [0, 1, 0], fovy_deg = 5"),
    BASE.case("silhouette", [100.0, 99.0, 89.0])
        .camera("eye = [1, 0, 5], look_at = [1, 0, 0], fovy_deg = 1"),
    BASE.case("seen from inside", [99.0, 88.0, 99.0])
        .camera(INSIDE),
    BASE.case("camera close to the surface", [98.0, 98.0, 87.0])
        .camera("eye = [0, 0, 1.001], look_at = [0.2, 0.1, 0], fovy_deg = 60"),
    BASE.case("seen down the y axis", [100.0, 98.0, 88.0])
        .camera("eye = [0, 9, 0], look_at = [0, 0, 0], up = [0, 0, -1], fovy_deg = 10"),
    BASE.case("seen from far away", [102.0, 102.0, 96.0])
        .camera(FAR_AWAY),
    BASE.case("tiny scene", [100.0, 102.0, 93.0])
        .camera(TINY)
        .shape("center = [0, 0, 0], radius = 0.001"),
    BASE.case("huge scene", [101.0, 101.0, 91.0])
        .camera(HUGE)
        .lights([30000.0, 40000.0, 50000.0], [2000.0, 3000.0, 1000.0])
        .shape("center = [0, 0, 0], radius = 10000"),
    BASE.case("far from the origin", [100.0, 101.0, 90.0])
        .camera("eye = [100001, -49999, 30004], look_at = [100000, -50000, 30000], fovy_deg = 33")
        .lights([100003.0, -49996.0, 30005.0], [100000.2, -49999.7, 30000.1])
        .shape("center = [100000, -50000, 30000], radius = 1"),
    BASE.case("checkered", [101.0, 101.0, 98.0]).checkered("xy"),
    BASE.case("above a floor", [98.0, 96.0, 92.0]).floor(-1.0),
    BASE.case("in front of a mirror", [99.0, 98.0, 93.0])
        .mirror(-1.5),
];
