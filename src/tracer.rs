//! The tree of rays of a pixel (Whitted 1980), walked by an explicit stack.

use heapless::Vec;

use crate::Color;
use crate::intersect;
use crate::num::{Factor, Radiance};
use crate::observer::{Node, Observer, RayKind, share};
use crate::prepared::{MAX_DEPTH, PreparedScene, Settings};
use crate::ray::Ray;
use crate::shade::Surface;
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
pub(crate) struct Stack(Vec<Branch, { MAX_DEPTH as usize }>);

/// The radiance that an eye ray brings back.
///
/// Not inlined: there is one copy of all tracing, whatever it is drawn into.
#[inline(never)]
pub(crate) fn trace(
    scene: &PreparedScene<'_>,
    ray: Ray,
    stack: &mut Stack,
    observer: &mut impl Observer,
) -> Color<Radiance> {
    let settings = &scene.settings;
    let mut radiance = Color::<Radiance>::BLACK;
    let mut budget = RAY_BUDGET;
    let mut next = Some(Branch {
        ray,
        weight: Color::WHITE,
        depth: 0,
        kind: RayKind::Eye,
    });
    stack.0.clear();
    while let Some(Branch {
        ray,
        weight,
        depth,
        kind,
    }) = next.or_else(|| stack.0.pop())
    {
        next = None;
        if budget == 0 {
            break;
        }
        budget -= 1;
        observer.ray(kind);
        let hit = intersect::nearest(scene, &ray, observer);
        let surface = hit.and_then(|hit| Surface::new(scene, &ray, hit));
        let local = match &surface {
            Some(surface) => surface.local(scene, &ray, observer),
            None => background(settings, &ray),
        };
        observer.node(&Node {
            kind,
            generation: depth,
            weight: share(weight),
            object: surface.map(|surface| surface.object()),
            inside: surface.is_some_and(|surface| surface.inside()),
            local: local.brightened(settings.exposure.into()),
        });
        radiance = radiance.plus(weight.weigh(local));
        let Some(surface) = surface else { continue };
        if depth == settings.max_depth {
            continue;
        }
        let bounces = surface.bounces(&ray);
        let branch = |(ray, share): (Ray, Color<Factor>), kind| {
            let weight = weight.filtered(share);
            let counts = !weight.all(|w| w < settings.min_weight);
            counts.then_some(Branch {
                ray,
                weight,
                depth: depth + 1,
                kind,
            })
        };
        next = bounces
            .reflected
            .and_then(|bounce| branch(bounce, RayKind::Reflected));
        let transmitted = bounces
            .transmitted
            .and_then(|bounce| branch(bounce, RayKind::Transmitted));
        if next.is_none() {
            next = transmitted;
        } else if let Some(transmitted) = transmitted {
            // There is room, as said above; no branch is lost.
            let _ = stack.0.push(transmitted);
        }
    }
    radiance.brightened(settings.exposure.into())
}

/// What a ray that hits nothing brings back.
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
