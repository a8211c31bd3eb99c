//! Cones: steep, flat, truncated, double and unbounded.

use super::case::{Case, FAR_AWAY, FROM_ABOVE, FROM_BELOW, HUGE, TINY, TO_HORIZON};

const BASE: Case = Case::new(
    "cone",
    "origin = [0, -1, 0], radius = 1, height = 2, y = [0, 2]",
    [0.1, -0.3, 0.1],
);

/// Double cone, which ends 1 above its apex.
const DOUBLE: &str = "origin = [0, -1, 0], radius = 1, height = 1, y = [0, 2]";

/// Double cone without end.
const UNBOUNDED: &str = "origin = [0, -1, 0], radius = 1, height = 2";

pub(crate) const CASES: &[Case] = &[
    BASE.case("front", [100.0, 100.0, 96.0]),
    BASE.case("open end seen from below", [99.0, 95.0, 98.0])
        .camera("eye = [1, -4, 2], look_at = [0, 0, 0], fovy_deg = 33"),
    BASE.case("seen down the axis", [102.0, 103.0, 99.0])
        .camera(FROM_ABOVE),
    BASE.case("seen up the axis", [99.0, 96.0, 98.0])
        .camera(FROM_BELOW),
    BASE.case("seen along its side", [99.0, 91.0, 98.0])
        .camera("eye = [2, -3, 0], look_at = [0.5, 0, 0], fovy_deg = 4"),
    BASE.case("grazing rays", [99.0, 91.0, 98.0])
        .camera("eye = [2.001, -3, 0], look_at = [0.5, 0, -0.05], fovy_deg = 5"),
    BASE.case("silhouette", [99.0, 99.0, 90.0])
        .camera("eye = [0.5, 0, 5], look_at = [0.5, 0, 0], fovy_deg = 2"),
    BASE.case("apex", [102.0, 102.0, 98.0])
        .camera("eye = [0.1, 1.2, 0.5], look_at = [0, 1, 0], fovy_deg = 10"),
    BASE.case("seen from inside", [99.0, 93.0, 95.0])
        .camera("eye = [0.3, -0.4, 0.2], look_at = [0, 1, -0.4], fovy_deg = 90"),
    BASE.case("rim", [98.0, 101.0, 93.0])
        .camera("eye = [0.2, -1.3, 2], look_at = [0, -1, 0.95], fovy_deg = 10"),
    BASE.case("apex down", [102.0, 103.0, 95.0])
        .second_light([0.1, 0.3, 0.1])
        .shape("origin = [0, 1, 0], radius = 1, height = -2, y = [-2, 0]"),
    BASE.case("truncated", [101.0, 100.0, 95.0])
        .shape("origin = [0, -1, 0], radius = 1, height = 3, y = [0.2, 1.8]"),
    BASE.case("clipped far from its origin", [99.0, 100.0, 95.0])
        .shape("origin = [0, -1001, 0], radius = 1000, height = 1002, y = [1000, 1002]"),
    BASE.case("seen from far away", [102.0, 102.0, 100.0])
        .camera(FAR_AWAY),
    BASE.case("tiny scene", [95.0, 100.0, 98.0])
        .camera(TINY)
        .shape("origin = [0, -0.001, 0], radius = 0.001, height = 0.002, y = [0, 0.002]"),
    BASE.case("huge scene", [101.0, 101.0, 97.0])
        .camera(HUGE)
        .lights([30000.0, 40000.0, 50000.0], [1000.0, -3000.0, 1000.0])
        .shape("origin = [0, -10000, 0], radius = 10000, height = 20000, y = [0, 20000]"),
    BASE.case("flat, 1:32", [102.0, 101.0, 100.0])
        .shape("origin = [0, 0, 0], radius = 1, height = 0.03125, y = [0, 0.03125]"),
    BASE.case("flat, 1:1024", [102.0, 101.0, 100.0])
        .shape("origin = [0, 0, 0], radius = 1, height = 0.0009765625, y = [0, 0.0009765625]"),
    BASE.case("steep, 32:1", [102.0, 102.0, 99.0])
        .camera("eye = [0.2, 0.5, 1], look_at = [0, 0.2, 0], fovy_deg = 60")
        .second_light([0.01, -0.3, 0.01])
        .shape("origin = [0, -1, 0], radius = 0.0625, height = 2, y = [0, 2]"),
    BASE.case("steep, 1024:1", [100.0, 102.0, 95.0])
        .camera("eye = [0.01, 0, 0.02], look_at = [0, -0.01, 0], fovy_deg = 30")
        .second_light([0.0001, -0.3, 0.0001])
        .shape("origin = [0, -1, 0], radius = 0.001953125, height = 2, y = [0, 2]"),
    BASE.case("double", [101.0, 100.0, 96.0]).shape(DOUBLE),
    BASE.case("double, apex", [99.0, 97.0, 93.0])
        .camera("eye = [0.02, 0.03, 0.5], look_at = [0, 0, 0], fovy_deg = 4")
        .shape(DOUBLE),
    BASE.case("double, seen down the axis", [101.0, 97.0, 94.0])
        .camera("eye = [0, 9, 0], look_at = [0, 0, 0], up = [0, 0, -1], fovy_deg = 16")
        .shape(DOUBLE),
    BASE.case("double, seen from inside", [100.0, 99.0, 96.0])
        .camera("eye = [0.1, -0.9, 0.1], look_at = [0, 1, -0.05], fovy_deg = 90")
        .shape(DOUBLE),
    BASE.case("double, flat, 1:1024", [102.0, 101.0, 95.0])
        .shape("origin = [0, 0, 0], radius = 1, height = 0.0009765625, y = [0, 0.001953125]"),
    BASE.case("checkered", [100.0, 101.0, 99.0]).checkered("xy"),
    BASE.case("on a floor", [98.0, 97.0, 95.0]).floor(-1.0),
    BASE.case("in front of a mirror", [99.0, 98.0, 97.0])
        .mirror(-1.5),
    BASE.case("unbounded", [100.0, 100.0, 98.0])
        .shape(UNBOUNDED),
    BASE.case("unbounded, seen from inside", [101.0, 99.0, 97.0])
        .camera("eye = [0.3, -0.4, 0.2], look_at = [0, -1, -0.4], fovy_deg = 90")
        .shape(UNBOUNDED),
    BASE.case("unbounded, seen up past the apex", [99.0, 98.0, 97.0])
        .camera("eye = [0, 1, 3], look_at = [0, 9, 0], fovy_deg = 60")
        .shape(UNBOUNDED),
    BASE.case("unbounded, seen in a mirror", [99.0, 97.0, 96.0])
        .camera("eye = [0, 0, 4], look_at = [0, 9, -9], fovy_deg = 40")
        .shape(UNBOUNDED)
        .mirror(-3.0),
    BASE.case("unbounded, on a floor", [99.0, 95.0, 97.0])
        .camera("eye = [2, 3, 12], look_at = [0, 0, -8], fovy_deg = 50")
        .shape("origin = [0, 0, -9], radius = 2, height = 1")
        .floor(0.0),
    BASE.case("unbounded, far reflection", [99.0, 99.0, 96.0])
        .camera(TO_HORIZON)
        .shape("origin = [0, 0, -9], radius = 1, height = 9")
        .floor(0.0),
    BASE.case("unbounded, seen in a far mirror", [98.0, 98.0, 96.0])
        .camera(TO_HORIZON)
        .shape("origin = [2, 0, -3], radius = 0.5, height = 3")
        .mirror(-60.0),
    BASE.case("unbounded, steep, 1024:1", [100.0, 100.0, 93.0])
        .camera("eye = [0.3, 0, 0.6], look_at = [0, 0.2, 0], fovy_deg = 60")
        .second_light([0.01, -0.3, 0.01])
        .shape("origin = [0, -1, 0], radius = 0.1, height = 102.4"),
    BASE.case("unbounded, flat, 1:1024", [99.0, 96.0, 98.0])
        .shape("origin = [0, 0, 0], radius = 1, height = 0.0009765625"),
];
