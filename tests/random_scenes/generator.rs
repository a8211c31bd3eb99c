//! Generates random scene files, one per seed.
//!
//! The generator works in a local space of about ±1. On output, a random scale
//! and offset map lengths and points to world space.

use fastrand::Rng;

/// A point, a direction or a color.
type Triple = [f64; 3];

pub(crate) struct RandomScene {
    pub(crate) toml: String,
    /// True if a material reflects or transmits.
    pub(crate) bounces: bool,
}

/// Number of materials, named `m0`, `m1` and so on.
const MATERIALS: usize = 4;

pub(crate) fn scene(seed: u64) -> RandomScene {
    let mut generator = Generator {
        rng: Rng::with_seed(seed),
        scale: 1.0,
        offset: [0.0; 3],
        out: String::new(),
    };
    let bounces = seed.is_multiple_of(2) || generator.chance(0.2);
    generator.scene(bounces);
    RandomScene {
        toml: generator.out,
        bounces,
    }
}

struct Generator {
    rng: Rng,
    /// World units per local unit, 0.1 to 10,000.
    scale: f64,
    /// Position of the local origin, in world units.
    offset: Triple,
    out: String,
}

/// Sphere that an object occupies, for placing others inside or next to it. In
/// local units.
#[derive(Clone, Copy)]
struct Place {
    center: Triple,
    size: f64,
}

impl Generator {
    /// Returns a random number in the range.
    fn number(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.rng.f64()
    }

    fn triple(&mut self, low: f64, high: f64) -> Triple {
        [0; 3].map(|_| self.number(low, high))
    }

    /// Returns true with this probability.
    fn chance(&mut self, share: f64) -> bool {
        self.rng.f64() < share
    }

    /// Appends a line to the scene file.
    fn line(&mut self, text: &str) {
        self.out.push_str(text);
        self.out.push('\n');
    }

    /// Formats a length in world units.
    fn length(&self, length: f64) -> String {
        format!("{:.8}", length * self.scale)
    }

    /// Formats a point in world units.
    fn point(&self, p: Triple) -> String {
        let [x, y, z] = [0, 1, 2].map(|i| p[i] * self.scale + self.offset[i]);
        format!("[{x:.8}, {y:.8}, {z:.8}]")
    }

    fn scene(&mut self, bounces: bool) {
        self.scale = 10_f64.powf(self.number(-1.0, 4.0));
        self.offset = self.triple(-3.0, 3.0).map(|c| c * self.scale);
        let depth = self.rng.u8(1..=6);
        let shading = ["phong", "blinn-phong"][usize::from(self.chance(0.5))];
        let background = if self.chance(0.5) {
            "{ horizon = [0.5, 0.6, 0.7], zenith = [0.1, 0.2, 0.6] }"
        } else {
            "[0.1, 0.2, 0.4]"
        };
        self.line(&format!("max_depth = {depth}\nmin_weight = 0"));
        self.line(&format!(
            "shading = \"{shading}\"\nbackground = {background}"
        ));
        let places = self.places();
        self.camera(&places);
        self.lights(&places);
        for index in 0..MATERIALS {
            self.material(index, bounces);
        }
        for (index, place) in places.into_iter().enumerate() {
            // The first object is a large sphere or ellipsoid, so that it covers
            // much of the picture.
            let kind = if index == 0 {
                self.rng.u8(0..2)
            } else {
                self.rng.u8(0..10)
            };
            self.object(kind, place);
        }
        if self.chance(0.7) {
            self.floor();
        }
        if self.chance(0.1) {
            self.unbounded();
        }
    }

    /// Places objects at random, inside the previous one, or touching it.
    fn places(&mut self) -> Vec<Place> {
        let mut places = vec![Place {
            center: self.triple(-0.1, 0.1),
            size: self.number(0.75, 0.95),
        }];
        for _ in 0..self.rng.u8(1..7) {
            let before = places[places.len() - 1];
            let size = self.number(0.08, 0.6);
            let place = match self.rng.u8(0..6) {
                0 => {
                    // Off center, so that surfaces do not coincide.
                    let size = before.size * self.number(0.5, 0.9);
                    let off = self.unit().map(|c| 0.05 * before.size * c);
                    Place {
                        center: [0, 1, 2].map(|i| before.center[i] + off[i]),
                        size,
                    }
                }
                1 => {
                    let away = self.unit().map(|c| c * (before.size + size));
                    Place {
                        center: [0, 1, 2].map(|i| before.center[i] + away[i]),
                        size,
                    }
                }
                _ => Place {
                    center: self.triple(-1.1, 1.1),
                    size,
                },
            };
            places.push(place);
        }
        places
    }

    /// Returns a random direction, of length 1 or less.
    fn unit(&mut self) -> Triple {
        let [x, y, z] = self.triple(-1.0, 1.0);
        let length = (x * x + y * y + z * z).sqrt().max(0.1);
        [x, y, z].map(|c| c / length)
    }

    fn camera(&mut self, places: &[Place]) {
        let first = places[0];
        let inside = self.chance(0.1);
        let (eye, fovy) = if inside {
            let place = places[self.rng.usize(0..places.len())];
            let off = self.unit().map(|c| 0.3 * place.size * c);
            let eye = [0, 1, 2].map(|i| place.center[i] + off[i]);
            (eye, self.number(40.0, 90.0))
        } else {
            let distance = self.number(1.5, 5.0);
            let [x, y, z] = [self.number(-1.0, 1.0), self.number(-0.3, 0.9), 1.0];
            let length = (x * x + y * y + z * z).sqrt();
            let eye = [x, y, z].map(|c| c / length * distance);
            let eye = [0, 1, 2].map(|i| first.center[i] + eye[i]);
            // The first object fills most of the height.
            let half = (first.size / distance).asin().to_degrees();
            (eye, (half * self.number(1.7, 2.2)).min(150.0))
        };
        let look_at = self.point(first.center);
        let eye = self.point(eye);
        self.line(&format!(
            "[camera]\neye = {eye}\nlook_at = {look_at}\nfovy_deg = {fovy:.4}"
        ));
    }

    fn lights(&mut self, places: &[Place]) {
        for _ in 0..self.rng.u8(1..3) {
            let position = if self.chance(0.15) {
                let place = places[self.rng.usize(0..places.len())];
                let off = self.unit().map(|c| self.number(0.3, 1.5) * place.size * c);
                [0, 1, 2].map(|i| place.center[i] + off[i])
            } else {
                [
                    self.number(-5.0, 5.0),
                    self.number(1.0, 8.0),
                    self.number(-2.0, 6.0),
                ]
            };
            let position = self.point(position);
            let color = self.triple(0.2, 0.9);
            self.line(&format!(
                "[[lights]]\nposition = {position}\ncolor = {color:.4?}"
            ));
        }
    }

    fn material(&mut self, index: usize, bounces: bool) {
        let kd = self.triple(0.05, 0.7);
        self.line(&format!(
            "[materials.m{index}]\nka = [0.05, 0.05, 0.05]\nkd = {kd:.4?}"
        ));
        if self.chance(0.6) {
            let (ks, shininess) = (self.triple(0.05, 0.6), 10_f64.powf(self.number(0.0, 3.3)));
            self.line(&format!("ks = {ks:.4?}\nshininess = {shininess:.4}"));
        }
        if !bounces {
            return;
        }
        // Material 0 always reflects; the first object has it.
        if index == 0 || self.chance(0.5) {
            let kr = self.triple(0.05, 0.7);
            self.line(&format!("kr = {kr:.4?}"));
        }
        if self.chance(0.5) {
            let (kt, ior) = (self.triple(0.3, 0.95), self.number(1.0, 2.5));
            self.line(&format!("kt = {kt:.4?}\nior = {ior:.4}"));
        }
    }

    /// Writes the material or the checkerboard of an object.
    fn texture(&mut self, first: bool) {
        if self.chance(0.15) {
            let number = self.number(0.1, 0.8);
            let size = self.length(number);
            let axes = ["xy", "yz", "xz"][self.rng.usize(0..3)];
            self.line(&format!(
                "checker = {{ size = {size}, axes = \"{axes}\", materials = [\"m0\", \"m1\"] }}"
            ));
        } else {
            let index = if first {
                0
            } else {
                self.rng.usize(0..MATERIALS)
            };
            self.line(&format!("material = \"m{index}\""));
        }
    }

    /// Writes an object of the kind 0 to 9.
    fn object(&mut self, kind: u8, place: Place) {
        let Place { center, size } = place;
        let at = self.point(center);
        let radius = self.length(size);
        self.line("[[objects]]");
        match kind {
            0 => self.line(&format!(
                "type = \"sphere\"\ncenter = {at}\nradius = {radius}"
            )),
            1 => self.ellipsoid(&at, size),
            2 | 3 => self.sphereflake(&at, size),
            4 | 5 => {
                self.line(&format!(
                    "type = \"cylinder\"\norigin = {at}\nradius = {radius}"
                ));
                self.clip(size);
            }
            6 | 7 => self.cone(&at, size),
            8 => self.paraboloid(&at, size),
            _ => self.plane(&at, place),
        }
        self.texture(size >= 0.75);
    }

    fn ellipsoid(&mut self, at: &str, size: f64) {
        // Most ellipsoids are nearly round, some flat or thin.
        let flat = match size {
            0.75.. => 0.85,
            _ if self.chance(0.3) => 0.04,
            _ => 0.5,
        };
        let radii = [0; 3].map(|_| self.number(flat, 1.0) * size);
        let [a, b, c] = radii.map(|radius| self.length(radius));
        self.line(&format!(
            "type = \"ellipsoid\"\ncenter = {at}\nradii = [{a}, {b}, {c}]"
        ));
    }

    fn cone(&mut self, at: &str, size: f64) {
        let height = size * 2_f64.powf(self.number(-2.0, 3.0));
        let height = if self.chance(0.2) { -height } else { height };
        let [radius, height] = [size, height].map(|length| self.length(length));
        self.line(&format!(
            "type = \"cone\"\norigin = {at}\nradius = {radius}\nheight = {height}"
        ));
        self.clip(size);
    }

    fn paraboloid(&mut self, at: &str, size: f64) {
        // As high as its place, unless that makes the paraboloid wider.
        let rise = (size * self.scale).min((size * self.scale).powi(2));
        let from = if self.chance(0.3) { 0.3 * rise } else { 0.0 };
        self.line(&format!(
            "type = \"paraboloid\"\norigin = {at}\ny = [{from:.8}, {rise:.8}]"
        ));
    }

    /// Writes a plane that is clipped to its place.
    fn plane(&mut self, at: &str, Place { center, size }: Place) {
        let normal = self.unit();
        let [x, y, z] = [0, 1, 2].map(|i| self.range(i, center[i] - size, center[i] + size));
        self.line(&format!(
            "type = \"plane\"\nnormal = {normal:.6?}\npoint = {at}"
        ));
        self.line(&format!("bounds = {{ x = {x}, y = {y}, z = {z} }}"));
    }

    /// Formats a range of positions on an axis, in world units.
    fn range(&self, axis: usize, low: f64, high: f64) -> String {
        let [low, high] = [low, high].map(|c| c * self.scale + self.offset[axis]);
        format!("[{low:.8}, {high:.8}]")
    }

    fn sphereflake(&mut self, at: &str, size: f64) {
        let depth = self.rng.u8(0..=3);
        let ratio = if self.chance(0.5) {
            1.0 / 3.0
        } else {
            self.number(0.1, 0.5)
        };
        // Bounding radius relative to the root sphere. Flakes with a ratio above 0.31
        // would shrink too much, so the factor is at most 1.9.
        let extent = (1.0 + ratio) / (1.0 - ratio);
        let radius = self.length(size / extent.min(1.9));
        self.line(&format!(
            "type = \"sphereflake\"\ncenter = {at}\nradius = {radius}"
        ));
        self.line(&format!("depth = {depth}\nratio = {ratio:.9}"));
        if self.chance(0.5) {
            let [u, v, w] = self.frame();
            self.line(&format!("frame = [{u:.10?}, {v:.10?}, {w:.10?}]"));
        }
    }

    /// Returns a random right-handed orthonormal basis.
    fn frame(&mut self) -> [Triple; 3] {
        let unit = |v: Triple| {
            let length = v.iter().map(|c| c * c).sum::<f64>().sqrt();
            v.map(|c| c / length)
        };
        let cross = |a: Triple, b: Triple| {
            [0, 1, 2].map(|i| {
                let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                a[j] * b[k] - a[k] * b[j]
            })
        };
        let mut w = self.unit();
        w[1] += 1.5;
        let w = unit(w);
        let u = unit(cross([0.3, 0.1, -1.0], w));
        [u, cross(w, u), w]
    }

    /// Writes the `y` limits of a cylinder or cone.
    fn clip(&mut self, size: f64) {
        let (low, high) = (self.number(-1.0, 0.4) * size, self.number(0.5, 1.5) * size);
        let (low, high) = (self.length(low), self.length(high));
        self.line(&format!("y = [{low}, {high}]"));
    }

    fn floor(&mut self) {
        let [x, _, z] = self.triple(-0.3, 0.3);
        let height = self.number(-1.2, -0.8);
        let at = self.point([0.0, height, 0.0]);
        self.line(&format!(
            "[[objects]]\ntype = \"plane\"\nnormal = [{x:.4}, 1, {z:.4}]\npoint = {at}"
        ));
        if self.chance(0.4) {
            let [x, z] = [0, 2].map(|axis| self.range(axis, -2.5, 3.0));
            self.line(&format!("bounds = {{ x = {x}, z = {z} }}"));
        }
        if self.chance(0.6) {
            let number = self.number(0.2, 1.5);
            let size = self.length(number);
            self.line(&format!(
                "checker = {{ size = {size}, axes = \"xz\", materials = [\"m0\", \"m1\"] }}"
            ));
        } else {
            self.line("material = \"m2\"");
        }
    }

    fn unbounded(&mut self) {
        let center = [
            self.number(-2.0, 2.0),
            self.number(-1.0, 1.0),
            self.number(-4.0, -1.0),
        ];
        let at = self.point(center);
        let number = self.number(0.1, 0.6);
        let radius = self.length(number);
        self.line("[[objects]]");
        if self.chance(0.5) {
            self.line(&format!(
                "type = \"cylinder\"\norigin = {at}\nradius = {radius}"
            ));
        } else {
            let number = self.number(0.2, 3.0);
            let height = self.length(number);
            self.line(&format!(
                "type = \"cone\"\norigin = {at}\nradius = {radius}\nheight = {height}"
            ));
        }
        self.texture(false);
    }
}
