//! Planes: clipped, slanted and unbounded.

use super::case::{Case, FAR_AWAY, FROM_ABOVE, HUGE, TINY};

const BASE: Case = Case::new(
    "plane",
    "normal = [0, 1, 0], point = [0, 0, 0], bounds = { x = [-1, 1], z = [-1, 1] }",
    [0.2, -3.0, 0.1],
);

/// Plane without end.
const UNBOUNDED: &str = "normal = [0, 1, 0], point = [0, 0, 0]";

pub(crate) const CASES: &[Case] = &[
    BASE.case("front", [102.0, 101.0, 100.0]),
    BASE.case("grazing rays", [101.0, 99.0, 97.0])
        .camera("eye = [0, 0.03, 3], look_at = [0, 0, 0], fovy_deg = 1"),
    BASE.case("seen along the normal", [101.0, 101.0, 98.0])
        .camera(FROM_ABOVE),
    BASE.case("camera close to the surface", [99.0, 98.0, 96.0])
        .camera("eye = [0, 0.001, 0.5], look_at = [0.2, 0, 0], fovy_deg = 60"),
    BASE.case("slanted", [101.0, 101.0, 98.0])
        .shape("normal = [0.3, 1, 0.2], point = [0, 0, 0], bounds = { x = [-1, 1], z = [-1, 1] }"),
    BASE.case("normal nearly parallel to an axis", [102.0, 101.0, 100.0])
        .shape("normal = [0.0001, 1, 0], point = [0, 0, 0], bounds = { x = [-1, 1], z = [-1, 1] }"),
    BASE.case("edge", [101.0, 98.0, 96.0])
        .camera("eye = [0.3, 0.2, 2], look_at = [0, 0, 1], fovy_deg = 6"),
    BASE.case("seen from far away", [102.0, 102.0, 102.0])
        .camera(FAR_AWAY),
    BASE.case("tiny scene", [102.0, 102.0, 100.0])
        .camera(TINY)
        .shape("normal = [0, 1, 0], point = [0, 0, 0], bounds = { x = [-0.001, 0.001], z = [-0.001, 0.001] }"),
    BASE.case("huge scene", [102.0, 101.0, 99.0])
        .camera(HUGE)
        .lights([30000.0, 40000.0, 50000.0], [2000.0, -30000.0, 1000.0])
        .shape("normal = [0, 1, 0], point = [0, 0, 0], bounds = { x = [-10000, 10000], z = [-10000, 10000] }"),
    BASE.case("checkered", [102.0, 102.0, 101.0])
        .checkered("xz"),
    BASE.case("in front of a mirror", [100.0, 98.0, 99.0])
        .mirror(-1.5),
    BASE.case("unbounded", [100.0, 96.0, 94.0])
        .shape(UNBOUNDED),
    BASE.case("unbounded, seen from below", [100.0, 103.0, 99.0])
        .camera("eye = [0, -1, 3], look_at = [0, 0, 0], fovy_deg = 60")
        .shape(UNBOUNDED),
    BASE.case("unbounded, with horizon", [100.0, 97.0, 96.0])
        .camera("eye = [0, 0.5, 3], look_at = [0, 0.5, 0], fovy_deg = 20")
        .shape(UNBOUNDED),
    BASE.case("unbounded, grazing rays", [99.0, 98.0, 96.0])
        .camera("eye = [0, 0.001, 3], look_at = [0, 0.001, 0], fovy_deg = 5")
        .shape(UNBOUNDED),
];
