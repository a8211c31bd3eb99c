//! Ellipsoids: round, flat and needle-shaped.

use super::case::{Case, FAR_AWAY, HUGE, TINY};

const BASE: Case = Case::new(
    "ellipsoid",
    "center = [0, 0, 0], radii = [1, 0.6, 0.8]",
    [0.2, 0.3, 0.1],
);

/// Flat ellipsoid, 1:256.
const DISK: &str = "center = [0, 0, 0], radii = [1, 0.00390625, 1]";

pub(crate) const CASES: &[Case] = &[
    BASE.case("front", [101.0, 102.0, 93.0]),
    BASE.case("grazing rays", [99.0, 99.0, 89.0])
        .camera("eye = [0, 0.6001, 3], look_at = [0, 0.6, 0], fovy_deg = 5"),
    BASE.case("silhouette", [100.0, 99.0, 91.0])
        .camera("eye = [1, 0, 5], look_at = [1, 0, 0], fovy_deg = 1"),
    BASE.case("seen from inside", [99.0, 88.0, 96.0])
        .camera("eye = [0.3, 0.1, 0.2], look_at = [1, 0.3, -1], fovy_deg = 90"),
    BASE.case("seen down an axis", [100.0, 99.0, 88.0])
        .camera("eye = [0, 9, 0], look_at = [0, 0, 0], up = [0, 0, -1], fovy_deg = 10"),
    BASE.case("seen along another axis", [100.0, 100.0, 92.0])
        .camera("eye = [9, 0, 0], look_at = [0, 0, 0], fovy_deg = 10"),
    BASE.case("seen from far away", [102.0, 102.0, 98.0])
        .camera(FAR_AWAY),
    BASE.case("tiny scene", [99.0, 102.0, 96.0])
        .camera(TINY)
        .shape("center = [0, 0, 0], radii = [0.001, 0.0006, 0.0008]"),
    BASE.case("huge scene", [101.0, 102.0, 94.0])
        .camera(HUGE)
        .lights([30000.0, 40000.0, 50000.0], [2000.0, 3000.0, 1000.0])
        .shape("center = [0, 0, 0], radii = [10000, 6000, 8000]"),
    BASE.case("lens, 1:16", [102.0, 101.0, 95.0])
        .second_light([0.2, 0.02, 0.1])
        .shape("center = [0, 0, 0], radii = [1, 0.0625, 1]"),
    BASE.case("disk, 1:256", [102.0, 101.0, 96.0])
        .second_light([0.2, 0.002, 0.1])
        .shape(DISK),
    // Seen edge-on, the normal turns by a right angle within 2^-16 of the disk's radius, a thousand position steps.
    BASE.case("disk seen from its edge", [81.0, 73.0, 86.0])
        .camera("eye = [0.3, 0.02, 4], look_at = [0, 0, 0], fovy_deg = 1")
        .second_light([0.2, 0.002, 0.1])
        .shape(DISK),
    BASE.case("disk seen from inside", [102.0, 86.0, 99.0])
        .camera("eye = [0, 0.001, 0.5], look_at = [0.3, 0, -1], fovy_deg = 90")
        .second_light([0.2, 0.002, 0.1])
        .shape(DISK),
    BASE.case("needle, 1:256", [102.0, 102.0, 97.0])
        .camera("eye = [0.05, 0.03, 1.1], look_at = [0, 0, 0.9], fovy_deg = 10")
        .second_light([0.001, 0.001, 0.2])
        .shape("center = [0, 0, 0], radii = [0.00390625, 0.00390625, 1]"),
    BASE.case("checkered", [101.0, 102.0, 99.0]).checkered("xz"),
    BASE.case("above a floor", [98.0, 97.0, 93.0]).floor(-0.6),
    BASE.case("in front of a mirror", [100.0, 99.0, 94.0])
        .mirror(-1.5),
];
