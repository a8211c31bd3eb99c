//! The tree of rays of a pixel (Whitted 1980), walked by an explicit stack.

use heapless::Vec;

use crate::Color;
use crate::intersect::{self, Part};
use crate::num::{Factor, Radiance, Unit};
use crate::observer::{Node, Observer, RayKind, share};
use crate::prepared::{MAX_DEPTH, PreparedScene, Settings};
use crate::ray::Ray;
use crate::shade::{Shares, Surface};
use crate::vector::round_unit;

/// Rays of one pixel, shadow rays apart, after which branches add black.
///
/// Depth alone allows 2^33.
pub(crate) const RAY_BUDGET: u16 = 4096;

/// A ray still to be traced.
#[derive(Clone, Copy, Debug)]
struct Branch {
    ray: Ray,
    kin: Kin,
}

/// Where a ray stands in the tree.
#[derive(Clone, Copy, Debug)]
struct Kin {
    /// How much of what it brings back reaches the eye.
    weight: Color<Factor>,
    generation: u8,
    kind: RayKind,
}

impl Kin {
    const EYE: Self = Self {
        weight: Color::WHITE,
        generation: 0,
        kind: RayKind::Eye,
    };
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
    observer.ray(RayKind::Eye);
    let part = &mut scratch.part;
    let hit = match candidates {
        Some(objects) => intersect::nearest_of(objects, scene, ray, part, observer),
        None => intersect::nearest(scene, ray, part, observer),
    };
    let mut radiance = Color::<Radiance>::BLACK;
    let eye = Kin::EYE;
    match hit {
        Some(hit) => {
            let surface = Surface::new(scene, ray, hit, part);
            surface.local(scene, &mut radiance, observer);
            tell(observer, scene, Some(&surface), eye, radiance);
            if surface.branches() && scene.settings.max_depth > 0 {
                tree(scene, &surface, scratch, &mut radiance, observer);
            }
        }
        None => {
            radiance = background(&scene.settings, ray.direction.y);
            tell(observer, scene, None, eye, radiance);
        }
    }
    if scene.settings.exposure == 0 {
        return radiance;
    }
    radiance.brightened(scene.settings.exposure.into())
}

/// Adds what the rays bring back that go on from where the eye ray hit.
#[inline(never)]
fn tree(
    scene: &PreparedScene<'_>,
    surface: &Surface<'_>,
    Scratch { stack, part }: &mut Scratch,
    radiance: &mut Color<Radiance>,
    observer: &mut impl Observer,
) {
    let Some(mut branch) = follow(surface, Kin::EYE, &scene.settings, stack) else {
        return;
    };
    for _ in 1..RAY_BUDGET {
        let Branch { ray, kin } = &branch;
        observer.ray(kin.kind);
        let next = match intersect::nearest(scene, ray, part, observer) {
            Some(hit) => {
                let surface = Surface::new(scene, ray, hit, part);
                let mut local = Color::<Radiance>::BLACK;
                surface.local(scene, &mut local, observer);
                tell(observer, scene, Some(&surface), *kin, local);
                *radiance = radiance.plus(kin.weight.weigh(local));
                if surface.branches() && kin.generation < scene.settings.max_depth {
                    follow(&surface, *kin, &scene.settings, stack)
                } else {
                    None
                }
            }
            None => {
                let background = background(&scene.settings, ray.direction.y);
                tell(observer, scene, None, *kin, background);
                *radiance = radiance.plus(kin.weight.weigh(background));
                None
            }
        };
        match next.or_else(|| stack.pop()) {
            Some(next) => branch = next,
            None => return,
        }
    }
    stack.clear();
}

/// Tells of a node of the tree.
#[inline(always)]
fn tell(
    observer: &mut impl Observer,
    scene: &PreparedScene<'_>,
    surface: Option<&Surface<'_>>,
    kin: Kin,
    local: Color<Radiance>,
) {
    observer.node(&Node {
        kind: kin.kind,
        generation: kin.generation,
        weight: share(kin.weight),
        object: surface.map(Surface::object),
        inside: surface.is_some_and(Surface::inside),
        local: local.brightened(scene.settings.exposure.into()),
    });
}

/// The branch that follows from a hit, if one does; what else follows is put off.
#[inline(never)]
fn follow(surface: &Surface<'_>, from: Kin, settings: &Settings, stack: &mut Stack) -> Option<Branch> {
    let Shares {
        reflected,
        transmitted,
        refraction,
    } = surface.shares();
    let follows = |share: Color<Factor>, kind| {
        let weight = from.weight.filtered(share);
        let counts = !share.is_black() && !weight.all(|w| w < settings.min_weight);
        counts.then_some(Kin {
            weight,
            generation: from.generation + 1,
            kind,
        })
    };
    let transmitted = match refraction {
        Some(direction) => follows(transmitted, RayKind::Transmitted).map(|kin| Branch {
            ray: surface.transmitted(direction),
            kin,
        }),
        None => None,
    };
    let Some(kin) = follows(reflected, RayKind::Reflected) else {
        return transmitted;
    };
    if let Some(transmitted) = transmitted {
        // There is room, as said above; no branch is lost.
        let _ = stack.push(transmitted);
    }
    Some(Branch {
        ray: surface.reflected(),
        kin,
    })
}

/// What a ray that hits nothing brings back.
#[inline(never)]
fn background(settings: &Settings, height: Unit) -> Color<Radiance> {
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
