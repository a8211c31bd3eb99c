use std::fs;
use std::path::Path;

use whitted::Color;
use whitted_sim::picture::Picture;
use whitted_sim::{png16, scene_file};

use crate::Outcome;

/// Valid inputs, from which the mutated inputs are made.
pub(crate) struct Seeds {
    pub(crate) scenes: Vec<String>,
    pub(crate) compiled: Vec<Vec<u8>>,
    pub(crate) pictures: Vec<Vec<u8>>,
}

impl Seeds {
    /// Reads and compiles the project's scenes, and makes small pictures.
    pub(crate) fn new() -> Outcome<Self> {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes");
        let mut paths = fs::read_dir(folder)?
            .map(|entry| Ok(entry?.path()))
            .collect::<Outcome<Vec<_>>>()?;
        paths.sort();
        let mut seeds = Self {
            scenes: Vec::new(),
            compiled: Vec::new(),
            pictures: vec![include_bytes!("../cli/inputs/interlaced.png").to_vec()],
        };
        for path in paths {
            seeds.scenes.push(fs::read_to_string(&path)?);
            seeds.compiled.push(scene_file::compile(&path)?);
        }
        seeds.scenes.push(ANIMATED.to_owned());
        seeds.pictures.push(picture()?);
        Ok(seeds)
    }
}

/// Returns a PNG of 3x2 pixels with 16 bits per channel.
fn picture() -> Outcome<Vec<u8>> {
    let pixel = |index: u16| Color::new(9000 * index, 65535 - 9000 * index, 100 * index);
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("mutations-seed.png");
    let picture = Picture {
        width: 3,
        height: 2,
        pixels: (0..6).map(pixel).collect(),
    };
    png16::write(&path, &picture)?;
    Ok(fs::read(path)?)
}

/// A small scene in which a track of each kind moves something.
const ANIMATED: &str = r#"max_depth = 4
min_weight = 0.01
background = { horizon = [0.5, 0.6, 0.7], zenith = [0.1, 0.2, 0.5] }
[camera]
eye = [0, 1, 8]
look_at = [0, 1, 0]
fovy_deg = 33
[[lights]]
name = "sun"
position = [0, 9, 0]
color = [1, 1, 1]
[materials.glass]
kr = [0.1, 0.1, 0.1]
kt = [0.9, 0.9, 0.9]
ior = "glass"
[materials.red]
kd = [0.7, 0.1, 0.1]
[[objects]]
type = "sphere"
name = "ball"
center = [0, 1, 0]
radius = 1
material = "glass"
[[objects]]
type = "cone"
origin = [2, 0, 0]
radius = 1
height = 2
y = [0, 2]
material = "red"
[animation]
duration = 2
[[animation.tracks]]
target = "camera.orbit"
keys = [[0, 0], [2, [180, 20]]]
[[animation.tracks]]
target = "objects.ball.center"
interpolation = "smooth"
keys = [[0, [0, 1, 0]], [1, [0, 3, 0]], [2, [0, 1, 0]]]
[[animation.tracks]]
target = "objects.ball.radius"
keys = [[0, 1], [2, 0.5]]
[[animation.tracks]]
target = "lights.sun.color"
keys = [[0, [1, 1, 1]], [2, [1, 0, 0.5]]]
"#;
