//! The tree of rays of a pixel (Whitted 1980), walked by an explicit stack.

use heapless::Vec;

use crate::Color;
use crate::intersect::{self, Hit, Part};
use crate::num::{Factor, Radiance};
use crate::observer::{Node, Observer, RayKind, share};
use crate::prepared::{MAX_DEPTH, PreparedScene, Settings};
use crate::ray::Ray;
use crate::shade::{Shares, Surface};
use crate::vector::round_unit;

/// Rays of one pixel, shadow rays apart, after which branches add black.
///
/// Depth alone allows 2^33.
pub(crate) const RAY_BUDGET: u16 = 4096;

/// A ray still to be traced, and how much of it reaches the eye.
#[derive(Clone, Copy, Debug)]
struct Branch {
    ray: Ray,
    weight: Color<Factor>,
    depth: u8,
    kind: RayKind,
}

/// Branches put off: a transmitted ray waits while the reflected one beside
/// it is followed, so there is at most one for each generation.
#[derive(Clone, Debug, Default)]
pub(crate) struct Scratch {
    stack: Stack,
    part: Part,
}

type Stack = Vec<Branch, { MAX_DEPTH as usize }>;

/// The radiance that an eye ray brings back, which may meet the `candidates` or,
/// if there are none given, anything.
///
/// Not inlined: there is one copy of all tracing, whatever it is drawn into.
#[inline(never)]
pub(crate) fn trace(
    scene: &PreparedScene<'_>,
    ray: &Ray,
    candidates: Option<&[u16]>,
    scratch: &mut Scratch,
    observer: &mut impl Observer,
) -> Color<Radiance> {
    let part = &mut scratch.part;
    let hit = match candidates {
        Some(objects) => intersect::nearest_of(objects, scene, ray, part, observer),
        None => intersect::nearest(scene, ray, part, observer),
    };
    observer.ray(RayKind::Eye);
    let radiance = match hit {
        Some(hit) => tree(scene, ray, hit, scratch, observer),
        None => background(&scene.settings, ray),
    };
    if scene.settings.exposure == 0 {
        return radiance;
    }
    radiance.brightened(scene.settings.exposure.into())
}

/// What the tree of rays from the hit of an eye ray brings back.
#[inline(never)]
fn tree(
    scene: &PreparedScene<'_>,
    ray: &Ray,
    hit: Hit,
    Scratch { stack, part }: &mut Scratch,
    observer: &mut impl Observer,
) -> Color<Radiance> {
    let settings = &scene.settings;
    let mut radiance = Color::<Radiance>::BLACK;
    let mut branch = Branch {
        ray: *ray,
        weight: Color::WHITE,
        depth: 0,
        kind: RayKind::Eye,
    };
    let mut hit = Some(hit);
    let mut budget = RAY_BUDGET;
    loop {
        let goes_on = match &hit {
            Some(hit) => {
                let surface = Surface::new(scene, &branch.ray, hit, part);
                let local = surface.local(scene, observer);
                radiance = radiance.plus(branch.weight.weigh(local));
                branch.depth < settings.max_depth && follow(&surface, settings, &mut branch, stack)
            }
            None => {
                radiance = radiance.plus(branch.weight.weigh(background(settings, &branch.ray)));
                false
            }
        };
        if !goes_on {
            let Some(next) = stack.pop() else {
                break;
            };
            branch = next;
        }
        budget -= 1;
        if budget == 0 {
            stack.clear();
            break;
        }
        observer.ray(branch.kind);
        hit = intersect::nearest(scene, &branch.ray, part, observer);
    }
    radiance
}

/// Turns a branch into the one that follows from its hit, and puts off what
/// else follows; false if nothing does.
#[inline(never)]
fn follow(
    surface: &Surface<'_>,
    settings: &Settings,
    branch: &mut Branch,
    stack: &mut Stack,
) -> bool {
    let Shares {
        reflected,
        transmitted,
        refraction,
    } = surface.shares();
    let counts = |share: Color<Factor>| {
        let weight = branch.weight.filtered(share);
        let counts = !share.is_black() && !weight.all(|w| w < settings.min_weight);
        counts.then_some(weight)
    };
    let (reflected, transmitted) = (counts(reflected), counts(transmitted));
    let depth = branch.depth + 1;
    if let Some(weight) = transmitted {
        let transmitted = Branch {
            ray: surface.transmitted(refraction),
            weight,
            depth,
            kind: RayKind::Transmitted,
        };
        if reflected.is_none() {
            *branch = transmitted;
            return true;
        }
        // There is room, as said above; no branch is lost.
        let _ = stack.push(transmitted);
    }
    if let Some(weight) = reflected {
        *branch = Branch {
            ray: surface.reflected(),
            weight,
            depth,
            kind: RayKind::Reflected,
        };
    }
    reflected.is_some()
}

/// What a ray that hits nothing brings back.
#[inline(never)]
fn background(settings: &Settings, ray: &Ray) -> Color<Radiance> {
    let height = ray.direction.y;
    if height <= 0 || settings.horizon == settings.zenith {
        return settings.horizon.into();
    }
    settings.horizon.zip(settings.zenith, |horizon, zenith| {
        let rise = i64::from(zenith.to_bits()) - i64::from(horizon.to_bits());
        // Q15 * Q30 -> Q30
        let risen = round_unit(rise * i64::from(height.to_bits()), 15).to_bits();
        Radiance::from_bits((u32::from(horizon.to_bits()) << 15).saturating_add_signed(risen))
    })
}
