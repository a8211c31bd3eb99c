//! Test pictures of one object: its shape, camera, lights and surroundings.

/// Camera at the default distance, above the object and to the right.
const FRONT: &str = "eye = [1, 1.2, 4], look_at = [0, 0, 0], fovy_deg = 33";
/// Camera straight above the object, looking down the y axis.
pub(crate) const FROM_ABOVE: &str =
    "eye = [0, 9, 0], look_at = [0, 0, 0], up = [0, 0, -1], fovy_deg = 20";
/// Camera straight below the object, looking up the y axis.
pub(crate) const FROM_BELOW: &str =
    "eye = [0, -9, 0], look_at = [0, 0, 0], up = [0, 0, -1], fovy_deg = 20";
/// Camera inside an object of radius 1.
pub(crate) const INSIDE: &str = "eye = [0.3, 0.1, 0.2], look_at = [1, 0.5, -1], fovy_deg = 90";
/// Camera 300 units from the object, with a field of view of 1 degree.
pub(crate) const FAR_AWAY: &str = "eye = [80, 100, 270], look_at = [0, 0, 0], fovy_deg = 1";
/// Camera looking nearly level, so that the picture shows the horizon.
pub(crate) const TO_HORIZON: &str = "eye = [1, 0.6, 6], look_at = [0, 0, -9], fovy_deg = 30";
/// Camera for an object 0.001 units in size.
pub(crate) const TINY: &str = "eye = [0.002, 0.003, 0.005], look_at = [0, 0, 0], fovy_deg = 33";
/// Camera for an object 10,000 units in size.
pub(crate) const HUGE: &str = "eye = [10000, 20000, 40000], look_at = [0, 0, 0], fovy_deg = 33";

/// Least agreement with the oracle, for one material.
#[derive(Clone, Copy)]
pub(crate) struct Limit {
    /// Least PSNR in dB.
    pub(crate) psnr: f64,
    /// Greatest number of pixels with an error above 1/255.
    pub(crate) outliers: usize,
}

/// Reflective plane that accompanies the tested object.
#[derive(Clone, Copy)]
enum Backdrop {
    None,
    /// Horizontal plane at this height.
    Floor(f64),
    /// Vertical plane at this z.
    Mirror(f64),
}

/// Test picture and its agreement limits.
#[derive(Clone, Copy)]
pub(crate) struct Case {
    pub(crate) name: &'static str,
    /// Limits for matte, mirror and glass.
    pub(crate) limits: [Limit; 3],
    camera: &'static str,
    lights: [[f64; 3]; 2],
    /// Type of the object in a scene file.
    kind: &'static str,
    /// Keys and values of the object's shape, as in a scene file.
    shape: &'static str,
    /// Checkerboard axes, or none for a uniform material.
    checker: Option<&'static str>,
    backdrop: Backdrop,
    max_depth: u8,
}

impl Case {
    /// Returns the base case of a surface, seen from the front. One light is
    /// outside the object, the other at `second_light`, mostly inside.
    pub(crate) const fn new(
        kind: &'static str,
        shape: &'static str,
        second_light: [f64; 3],
    ) -> Self {
        Self {
            name: "",
            limits: [Limit {
                psnr: f64::INFINITY,
                outliers: 0,
            }; 3],
            camera: FRONT,
            lights: [[3.0, 4.0, 5.0], second_light],
            kind,
            shape,
            checker: None,
            backdrop: Backdrop::None,
            max_depth: 5,
        }
    }

    /// Names the case and sets its least PSNR in dB for matte, mirror and glass.
    pub(crate) const fn case(mut self, name: &'static str, psnr: [f64; 3]) -> Self {
        self.name = name;
        self.limits[0].psnr = psnr[0];
        self.limits[1].psnr = psnr[1];
        self.limits[2].psnr = psnr[2];
        self
    }

    /// Allows pixels with an error above 1/255, for matte, mirror and glass.
    pub(crate) const fn outliers(mut self, counts: [usize; 3]) -> Self {
        self.limits[0].outliers = counts[0];
        self.limits[1].outliers = counts[1];
        self.limits[2].outliers = counts[2];
        self
    }

    pub(crate) const fn camera(self, camera: &'static str) -> Self {
        Self { camera, ..self }
    }

    pub(crate) const fn lights(self, first: [f64; 3], second: [f64; 3]) -> Self {
        Self {
            lights: [first, second],
            ..self
        }
    }

    pub(crate) const fn second_light(self, position: [f64; 3]) -> Self {
        self.lights(self.lights[0], position)
    }

    pub(crate) const fn shape(self, shape: &'static str) -> Self {
        Self { shape, ..self }
    }

    pub(crate) const fn checkered(self, axes: &'static str) -> Self {
        Self {
            checker: Some(axes),
            ..self
        }
    }

    pub(crate) const fn floor(self, y: f64) -> Self {
        Self {
            backdrop: Backdrop::Floor(y),
            ..self
        }
    }

    pub(crate) const fn mirror(self, z: f64) -> Self {
        Self {
            backdrop: Backdrop::Mirror(z),
            ..self
        }
    }

    pub(crate) const fn max_depth(self, max_depth: u8) -> Self {
        Self { max_depth, ..self }
    }

    /// Returns the scene file, with the object as its first object.
    pub(crate) fn toml(&self, material: &str) -> String {
        let &Self {
            camera,
            lights: [first, second],
            kind,
            shape,
            max_depth,
            ..
        } = self;
        let texture = match self.checker {
            Some(axes) => format!(
                r#"checker = {{ size = 0.3, axes = "{axes}", materials = ["main", "other"] }}"#
            ),
            None => r#"material = "main""#.to_owned(),
        };
        let backdrop = self.backdrop.toml();
        format!(
            r#"
max_depth = {max_depth}
min_weight = 0
background = {{ horizon = [0.5, 0.6, 0.7], zenith = [0.1, 0.2, 0.6] }}
camera = {{ {camera} }}
lights = [
  {{ position = {first:?}, color = [0.7, 0.7, 0.7] }},
  {{ position = {second:?}, color = [0.2, 0.1, 0.1] }},
]
materials.main = {{ {material} }}
materials.other = {{ kd = [0.2, 0.5, 0.3], ka = [0.1, 0.1, 0.1], kr = [0.3, 0.3, 0.3] }}
objects = [{{ type = "{kind}", {shape}, {texture} }}{backdrop}]
"#
        )
    }
}

impl Backdrop {
    fn toml(self) -> String {
        let (normal, point) = match self {
            Self::None => return String::new(),
            Self::Floor(y) => ([0, 1, 0], [0.0, y, 0.0]),
            Self::Mirror(z) => ([0, 0, 1], [0.0, 0.0, z]),
        };
        format!(
            r#", {{ type = "plane", normal = {normal:?}, point = {point:?}, material = "other" }}"#
        )
    }
}
