//! Spheres spread evenly over the view.

use std::collections::BTreeSet;
use std::fmt;
use std::fmt::Write;

use anyhow::Result;
use embedded_graphics_core::geometry::Size;
use whitted::Renderer;
use whitted::observer::{Observer, RayKind, RayNode, ShapeKind, Stats};
use whitted_sim::{render, scene_file};

/// Spheres a side: 1 to 256 in all.
pub(super) const SIDES: [u32; 5] = [1, 2, 4, 8, 16];

/// The size of the pictures.
pub(super) const SIZE: &str = "320x240";
const PIXELS: Size = Size::new(320, 240);

/// What of the view, at the spheres' distance, the picture shows; in world units.
const VIEW: [f64; 2] = [8.0, 6.0];
/// A sphere's radius in the height of its cell of the view.
const RADIUS: f64 = 0.4;

/// What all pictures have in common. The field of view is 2 atan(3 / 10), so
/// that the picture shows [`VIEW`] ten units ahead.
const SETTING: &str = "\
max_depth = 2
ambient = [1.0, 1.0, 1.0]
background = [0.1, 0.15, 0.25]

[camera]
eye = [0.0, 0.0, 10.0]
look_at = [0.0, 0.0, 0.0]
fovy_deg = 33.398488

[materials.ball]
ka = [0.06, 0.03, 0.02]
kd = [0.6, 0.3, 0.2]
ks = [0.4, 0.4, 0.4]
shininess = 50.0
";

const MIRROR: &str = "kr = [0.3, 0.3, 0.3]\n";

const LIGHT: &str = "
[[lights]]
position = [-6.0, 8.0, 10.0]
color = [0.9, 0.9, 0.9]
";

/// Which rays a picture takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Rays {
    /// Those of the eye: nothing is lit, nothing reflects.
    Eye,
    /// Shadow rays too.
    EyeAndShadow,
    /// Reflected ones too, in two generations.
    All,
}

impl Rays {
    pub(super) const ALL: [Self; 3] = [Self::Eye, Self::EyeAndShadow, Self::All];
}

/// A picture of so many spheres a side, in a grid that fills the view.
#[derive(Clone, Copy, Debug)]
pub(super) struct Crowd {
    pub(super) side: u32,
    pub(super) rays: Rays,
}

impl fmt::Display for Crowd {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "crowd_{}_{:?}", self.side * self.side, self.rays)
    }
}

impl Crowd {
    /// The scene file.
    pub(super) fn toml(self) -> String {
        let mut toml = SETTING.to_owned();
        if self.rays == Rays::All {
            toml += MIRROR;
        }
        if self.rays != Rays::Eye {
            toml += LIGHT;
        }
        let side = f64::from(self.side);
        let [width, height] = VIEW.map(|length| length / side);
        for row in 0..self.side {
            for column in 0..self.side {
                let x = (f64::from(column) + 0.5 - side / 2.0) * width;
                let y = (f64::from(row) + 0.5 - side / 2.0) * height;
                // Writing to a string cannot fail.
                _ = write!(
                    toml,
                    "\n[[objects]]\ntype = \"sphere\"\ncenter = [{x:?}, {y:?}, 0.0]\n\
                     radius = {:?}\nmaterial = \"ball\"\n",
                    RADIUS * height
                );
            }
        }
        toml
    }

    /// What there was to see while this machine drew it, and the checksum.
    pub(super) fn drawn_here(self) -> Result<(Seen, String)> {
        let file = scene_file::parse(&self.to_string(), &self.toml())?;
        let mut buffer = Box::new(scene_file::Buffer::new());
        let scene = file.prepare(&mut buffer)?;
        let mut renderer = Renderer::with_observer(&scene, PIXELS, Seen::default());
        let picture = render::trace(&mut renderer, |_| {});
        let checksum = format!("{:08x}", render::checksum(&picture));
        Ok((renderer.observer().clone(), checksum))
    }
}

/// Rays, and what the eye met on each line.
#[derive(Clone, Debug, Default)]
pub(super) struct Seen {
    pub(super) stats: Stats,
    /// Line and object.
    on_lines: BTreeSet<(u32, u16)>,
}

impl Seen {
    /// Objects that a line shows, on average.
    pub(super) fn per_line(&self) -> f64 {
        self.on_lines.len() as f64 / f64::from(PIXELS.height)
    }

    /// Rays of all kinds.
    pub(super) fn queries(&self) -> u64 {
        let Stats {
            camera: eye,
            reflected,
            transmitted,
            shadow,
            ..
        } = self.stats;
        [eye, reflected, transmitted, shadow]
            .map(u64::from)
            .iter()
            .sum()
    }
}

impl Observer for Seen {
    fn ray(&mut self, kind: RayKind) {
        self.stats.ray(kind);
    }

    fn test(&mut self, shape: ShapeKind, met: bool) {
        self.stats.test(shape, met);
    }

    fn node(&mut self, node: &RayNode) {
        if let (RayKind::Camera, Some(object)) = (node.kind, node.object) {
            // One ray for each pixel so far, in the order of the lines.
            let line = (self.stats.camera - 1) / PIXELS.width;
            self.on_lines.insert((line, object));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn seen(side: u32, rays: Rays) -> Result<Seen> {
        Ok(Crowd { side, rays }.drawn_here()?.0)
    }

    #[test]
    fn a_line_shows_as_many_spheres_as_the_grid_has_of_them() -> Result<()> {
        // 0.4 of a cell's height above its middle and below, and some more: the
        // great ones bulge towards the eye, those at the edge look stretched.
        for (side, low, high) in [(1, 0.80, 0.84), (4, 3.2, 3.25), (8, 6.4, 6.6)] {
            let per_line = seen(side, Rays::Eye)?.per_line();
            assert!((low..high).contains(&per_line), "{side}: {per_line}");
        }
        Ok(())
    }

    #[test]
    fn each_picture_adds_a_kind_of_ray() -> Result<()> {
        let [eye, shadow, all] = Rays::ALL.map(|rays| seen(2, rays).map(|seen| seen.stats));
        let (eye, shadow, all) = (eye?, shadow?, all?);
        assert_eq!((eye.camera, eye.shadow, eye.reflected), (76_800, 0, 0));
        assert!(shadow.shadow > 0 && shadow.reflected == 0);
        assert!(all.shadow > shadow.shadow && all.reflected > 0);
        Ok(())
    }
}
