//! Which objects the eye rays of a line may meet, and between which columns.
//!
//! Through each line of pixels goes a plane of eye rays. It cuts a bounding
//! sphere in a circle, and the tangents from the eye to that circle are the
//! ends of the columns from which the sphere may be seen.

use fixed::types::I8F56;
use heapless::Vec;

use crate::geometry::{BoundingSphere, Shape};
use crate::math::{Length, Product, Square, high, square_root};
use crate::prepare::PreparedScene;
use crate::render::camera_rays::{CameraRays, ScanlinePlane};
use crate::trace::{Candidates, MOST};

/// More objects than these in one line are not told apart: all rays of the
/// line are then traced against all objects.

/// The objects of a line.
#[derive(Clone, Debug, Default)]
pub(crate) struct ScanlineCuller {
    spans: Vec<Span, MOST>,
    /// How many of the spans come before those that are all of planes.
    curved: u8,
    /// How many come before those that are all of planes that all rays approach alike.
    aslant: u8,
    /// What is at a column.
    here: Candidates,
    /// From which column on that may be something else.
    change: u32,
}

/// Columns, the last of them not included.
#[derive(Clone, Copy, Debug)]
struct Span {
    object: u16,
    from: u16,
    to: u16,
}

impl ScanlineCuller {
    /// Finds the objects of line `y`: the finite ones first, as all other rays look at
    /// them, so that of two surfaces in one place the same is seen.
    pub(crate) fn look(&mut self, scene: &PreparedScene<'_>, view: &CameraRays, y: u32) {
        self.spans.clear();
        self.change = 0;
        let row = view.row(&scene.settings.camera, y);
        let whole = [0, row.width];
        let mut fits = true;
        for around in scene.finite {
            let columns = columns(&around.bound(), &row);
            if let Some(columns) = columns {
                fits &= self.add(around.object, columns);
            }
        }
        self.curved = self.spans.len() as u8;
        self.aslant = self.spans.len() as u8;
        for &object in scene.endless {
            let shape = scene.objects.get(usize::from(object)).map(|it| &it.shape);
            let (is_flat, is_along) = match shape {
                Some(Shape::Plane(plane)) if !row.may_meet(plane) => continue,
                Some(Shape::Plane(plane)) => (true, row.is_along(plane)),
                _ => (false, false),
            };
            fits &= self.add(object, whole);
            let number = self.spans.len() as u8;
            if !is_flat {
                self.curved = number;
            }
            if !is_along {
                self.aslant = number;
            }
        }
        self.here.are_complete = fits;
    }

    #[inline(never)]
    fn add(&mut self, object: u16, [from, to]: [u16; 2]) -> bool {
        from >= to || self.spans.push(Span { object, from, to }).is_ok()
    }

    /// What the ray through column `x` may meet, columns being asked for in rising order.
    #[inline]
    pub(crate) fn at(&mut self, x: u32) -> &mut Candidates {
        if x >= self.change {
            self.advance(x);
        }
        &mut self.here
    }

    #[inline(never)]
    fn advance(&mut self, x: u32) {
        let here = &mut self.here;
        here.objects.clear();
        here.are_flat = here.are_complete;
        here.are_level = here.are_complete;
        here.met = None;
        self.change = u32::MAX;
        for (span, number) in self.spans.iter().zip(0..) {
            let (from, to) = (u32::from(span.from), u32::from(span.to));
            if x < from {
                self.change = self.change.min(from);
            } else if x < to {
                self.change = self.change.min(to);
                here.are_flat &= number >= self.curved;
                here.are_level &= here.objects.is_empty() && number >= self.aslant;
                // There is room for all of them.
                let _ = here.objects.push(span.object);
            }
        }
    }
}

/// The columns of a line from which a bounding sphere may be seen; `None` if
/// there are none.
///
/// In the line's plane, let the center be u to the right of the eye and e
/// ahead, and a aside of it. The plane cuts the sphere in a circle of radius
/// `P = sqrt((r - a) (r + a))`; with `L² = u² + e² + a² - r²` its tangents are at
/// `(u e ± P L) / (e² - P²)`: no difference but that of e and P can cancel.
fn columns(bound: &BoundingSphere, row: &ScanlinePlane) -> Option<[u16; 2]> {
    /// More than all roundings.
    const MARGIN: Length = Length::lit("0.00001");
    let whole = Some([0, row.width]);
    let radius: Length = bound.radius + (bound.radius >> 10) + MARGIN;
    let center = bound.center - row.eye;
    // Q58 -> Q26 -> Q28
    let along = |axis| Length::from_bits(high(center.along(axis).to_bits()) << 2);
    let aside = along(row.aside);
    if aside.abs() > radius {
        return None;
    }
    let ahead = along(row.ahead);
    let square = (radius - aside).product(radius + aside);
    let reach = Length::from_bits(square_root(square.to_bits() as u64) as i32);
    if ahead < -reach {
        return None;
    }
    let tangent_squared = center.squared() - radius.square();
    if ahead <= reach || tangent_squared <= 0 {
        return whole;
    }
    let tangent = Length::from_bits(square_root(tangent_squared.to_bits() as u64) as i32);
    let middle = along(row.right).product(ahead);
    let aslant = reach.product(tangent);
    let divisor = (ahead - reach).product(ahead.saturating_add(reach));
    let end = |n: I8F56| row.column(n.to_bits(), divisor.to_bits() as u64);
    let from = end(middle - aslant).saturating_sub(1);
    let to = end(middle + aslant).saturating_add(2);
    Some([from.min(row.width), to.min(row.width)])
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    extern crate std;

    use fastrand::Rng;
    use std::boxed::Box;
    use std::println;
    use std::vec::Vec;

    use super::{Candidates, MOST};
    use crate::math::{Color, Real, Vec3};
    use crate::render::camera_rays::CameraRays;
    use crate::render::scanline::ScanlineTracer;
    use crate::scene::{
        Background, Camera, ClipBox, Material, MaterialId, Object, Scene, Shape, Texture,
    };
    use crate::scene_buffer::SceneBuffer;
    use crate::trace::intersect::PrimitivePart;
    use crate::trace::trace;

    const SCENES: u64 = if cfg!(miri) { 1 } else { 150 };

    fn real(rng: &mut Rng, low: f64, high: f64) -> Real {
        Real::from_num(low + (high - low) * rng.f64())
    }

    fn point(rng: &mut Rng, reach: f64) -> Vec3<Real> {
        let mut c = || real(rng, -reach, reach);
        Vec3::new(c(), c(), c())
    }

    /// Spheres of all sizes, some around the eye, a few others, and planes.
    fn object(rng: &mut Rng) -> Shape {
        let center = point(rng, 2.0);
        let radius = Real::from_num(10_f64.powf(-2.3 + 2.5 * rng.f64()));
        match rng.u8(0..10) {
            0 => Shape::Ellipsoid {
                center,
                radii: Vec3::new(radius, radius / 2, radius * 2),
            },
            1 => Shape::Cylinder {
                origin: center,
                radius,
                y: Some([-radius, radius * 2]),
            },
            2 => Shape::Cone {
                origin: center,
                radius,
                height: radius * 2,
                y: Some([Real::ZERO, radius]),
            },
            3 => Shape::Paraboloid {
                origin: center,
                y: [radius / 8, radius],
            },
            4 => Shape::Plane {
                normal: point(rng, 1.0),
                point: center,
                bounds: Default::default(),
            },
            _ => Shape::Sphere { center, radius },
        }
    }

    /// Materials that glow in colors of their own, so that what is met is seen.
    fn materials(rng: &mut Rng) -> Vec<Material> {
        let mut glow = || real(rng, 0.1, 1.0);
        (0..8)
            .map(|_| Material {
                le: Color::new(glow(), glow(), glow()),
                ..Material::default()
            })
            .collect()
    }

    /// Draws a scene line by line, and holds each pixel against a ray that may meet anything.
    /// Returns how many pixels show an object.
    fn covered(scene: &Scene<'_>, [width, height]: [u32; 2]) -> usize {
        let mut buffer = Box::new(SceneBuffer::<96, 1, 8>::new());
        let prepared = buffer.prepare(scene).unwrap();
        let view = CameraRays::new(&prepared.settings.camera, width, height);
        let (mut raster, mut part) = (ScanlineTracer::new(&prepared), PrimitivePart::default());
        let mut covered = 0;
        for y in 0..height {
            let directions = view.line(y);
            let observer = &mut ();
            let pixels = raster.pixels(&view, y, view.columns(), observer);
            for ((x, color), direction) in pixels.zip(directions) {
                let anything = &mut Candidates::default();
                let expected = trace(&prepared, direction, anything, &mut part, &mut ());
                assert_eq!(color, expected, "{scene:?}, at ({x}, {y})");
                covered += usize::from(color != Color::default());
            }
        }
        covered
    }

    fn scene<'s>(camera: Camera, objects: &'s [Object], materials: &'s [Material]) -> Scene<'s> {
        Scene {
            objects,
            materials,
            background: Background::Solid(Color::gray(Real::ZERO)),
            ..Scene::new(camera)
        }
    }

    /// What a line passes over as out of view is met by no ray.
    #[test]
    fn a_line_has_the_colors_of_rays_that_may_meet_anything() {
        let mut rng = Rng::with_seed(7);
        let (mut seen, mut pixels) = (0, 0);
        for number in 0..SCENES {
            let materials = materials(&mut rng);
            let objects: Vec<_> = (0..rng.u16(1..90))
                .map(|n| Object {
                    shape: object(&mut rng),
                    texture: Texture::Uniform(MaterialId(n % 8)),
                })
                .collect();
            let fovy = real(&mut rng, 2.0, 169.0);
            let camera = Camera::new(point(&mut rng, 2.5), point(&mut rng, 2.0), fovy);
            let size = [[64, 48], [17, 90], [120, 9]][number as usize % 3];
            seen += covered(&scene(camera, &objects, &materials), size);
            pixels += (size[0] * size[1]) as usize;
        }
        println!("{seen} of {pixels} pixels covered");
        // One scene alone may be full.
        assert!(seen > pixels / 4 && (SCENES == 1 || seen < pixels * 9 / 10));
    }

    /// Some reach to where nothing is near, some are in front of others, and some end in view.
    #[test]
    fn planes_that_a_line_runs_along_end_where_they_do_for_any_ray() {
        let mut rng = Rng::with_seed(9);
        let size = if cfg!(miri) { [12, 16] } else { [48, 64] };
        let (mut seen, mut pixels) = (0, 0);
        for _ in 0..SCENES {
            let materials = materials(&mut rng);
            let objects: Vec<_> = (0..rng.u16(1..4))
                .map(|n| {
                    let reach = 10_f64.powf(3.0 * rng.f64());
                    let mut bound = || {
                        let low = real(&mut rng, -reach, reach);
                        let high = low + real(&mut rng, 0.0, reach);
                        rng.bool().then_some([low, high])
                    };
                    let bounds = ClipBox {
                        x: bound(),
                        y: None,
                        z: bound(),
                    };
                    let shape = Shape::Plane {
                        normal: Vec3::new(0, 1, 0).map(Real::from_num),
                        point: point(&mut rng, 1.0),
                        bounds,
                    };
                    let texture = Texture::Uniform(MaterialId(n));
                    Object { shape, texture }
                })
                .collect();
            let camera = Camera::new(
                point(&mut rng, 2.0),
                point(&mut rng, 2.0),
                real(&mut rng, 20.0, 120.0),
            );
            seen += covered(&scene(camera, &objects, &materials), size);
            pixels += (size[0] * size[1]) as usize;
        }
        println!("{seen} of {pixels} pixels covered");
        assert!(seen > pixels / 10);
    }

    /// Balls side by side, and a wall behind them, for which there may be no room left.
    #[test]
    fn a_line_of_too_many_objects_shows_all_of_them() {
        let mut rng = Rng::with_seed(8);
        let materials = materials(&mut rng);
        let at = |x: i32, z: i32| Vec3::new(x, 0, z).map(Real::from_num);
        let middle = MOST as i32 / 2;
        let camera = Camera::new(at(middle, 80), at(middle, 0), Real::from_num(2.5));
        for count in MOST as u16 - 1..=MOST as u16 + 1 {
            let balls = (0..count).map(|n| Shape::Sphere {
                center: at(n.into(), 0),
                radius: Real::from_num(0.6),
            });
            let wall = Shape::Plane {
                normal: at(0, 1),
                point: at(0, -10),
                bounds: Default::default(),
            };
            let objects: Vec<_> = balls
                .chain([wall])
                .zip(0..)
                .map(|(shape, n)| Object {
                    shape,
                    texture: Texture::Uniform(MaterialId(n % 8)),
                })
                .collect();
            for objects in [&objects[..], &objects[..count.into()]] {
                assert!(covered(&scene(camera, objects, &materials), [160, 8]) > 0);
            }
        }
    }
}
