//! The tree of rays of a pixel (Whitted 1980), walked by an explicit stack.

use heapless::Vec;

use crate::Color;
use crate::coverage::Candidates;
use crate::intersect::{self, Part};
use crate::num::{Factor, Product, Radiance, Unit};
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

    /// A ray that follows with a share of the weight, if that counts.
    #[inline(always)]
    fn child(&self, share: Color<Factor>, kind: RayKind, settings: &Settings) -> Option<Self> {
        let weight = self.weight.filtered(share);
        let counts = !share.is_black() && !weight.all(|w| w < settings.min_weight);
        counts.then_some(Self {
            weight,
            generation: self.generation + 1,
            kind,
        })
    }
}

/// What tracing a pixel writes to.
#[derive(Clone, Debug, Default)]
pub(crate) struct Scratch {
    stack: Stack,
    part: Part,
}

/// Branches put off: a transmitted ray waits while the reflected one beside
/// it is followed, so there is at most one for each generation.
type Stack = Vec<Branch, { MAX_DEPTH as usize }>;

/// The radiance that an eye ray brings back, of which candidates are known. Its
/// direction is below 2 in length and made a unit vector if need be: planes and what
/// they reflect diffusely can do without.
///
/// Not inlined: there is one copy of all tracing, whatever it is drawn into.
#[inline(never)]
pub(crate) fn trace(
    scene: &PreparedScene<'_>,
    ray: &mut Ray,
    candidates: Candidates<'_>,
    scratch: &mut Scratch,
    observer: &mut impl Observer,
) -> Color<Radiance> {
    observer.ray(RayKind::Eye);
    let part = &mut scratch.part;
    if !candidates.are_flat {
        ray.direction = ray.direction.unit();
    }
    let hit = match candidates.objects {
        Some([]) => None,
        Some(objects) => intersect::nearest_of(objects, scene, ray, part, observer),
        None => intersect::nearest(scene, ray, part, observer),
    };
    let mut radiance = Color::<Radiance>::BLACK;
    let eye = Kin::EYE;
    match hit {
        Some(hit) => {
            let mut surface = Surface::new(scene, ray, hit, part);
            if candidates.are_flat && !surface.is_matte() {
                make_unit(ray);
                surface.look_along(ray.direction);
            }
            surface.local(scene, &mut radiance, observer);
            tell(observer, scene, Some(&surface), eye, radiance);
            if surface.branches() && scene.settings.max_depth > 0 {
                tree(scene, ray, &surface, scratch, &mut radiance, observer);
            }
        }
        None => {
            if candidates.are_flat && scene.settings.is_gradient() {
                make_unit(ray);
            }
            radiance = background(&scene.settings, ray.direction.y);
            tell(observer, scene, None, eye, radiance);
        }
    }
    if scene.settings.exposure == 0 {
        return radiance;
    }
    radiance.brightened(scene.settings.exposure.into())
}

#[inline(never)]
fn make_unit(ray: &mut Ray) {
    ray.direction = ray.direction.unit();
}

/// Adds what the rays bring back that go on from where the eye ray hit.
#[inline(always)]
fn tree(
    scene: &PreparedScene<'_>,
    ray: &Ray,
    surface: &Surface<'_>,
    Scratch { stack, part }: &mut Scratch,
    radiance: &mut Color<Radiance>,
    observer: &mut impl Observer,
) {
    let mut branch = Branch {
        ray: *ray,
        kin: Kin::EYE,
    };
    let mut goes_on = follow(surface, &scene.settings, &mut branch, stack);
    for _ in 1..RAY_BUDGET {
        if !goes_on {
            let Some(next) = stack.pop() else {
                return;
            };
            branch = next;
        }
        goes_on = visit(scene, &mut branch, stack, part, radiance, observer);
    }
    stack.clear();
}

/// Traces a branch, adds what it brings back, and turns it into the one that
/// follows; false if none does.
#[inline(never)]
fn visit(
    scene: &PreparedScene<'_>,
    branch: &mut Branch,
    stack: &mut Stack,
    part: &mut Part,
    radiance: &mut Color<Radiance>,
    observer: &mut impl Observer,
) -> bool {
    observer.ray(branch.kin.kind);
    let Some(hit) = intersect::nearest(scene, &branch.ray, part, observer) else {
        let background = background(&scene.settings, branch.ray.direction.y);
        tell(observer, scene, None, branch.kin, background);
        *radiance = radiance.plus(branch.kin.weight.weigh(background));
        return false;
    };
    let surface = Surface::new(scene, &branch.ray, hit, part);
    let mut local = Color::<Radiance>::BLACK;
    surface.local(scene, &mut local, observer);
    tell(observer, scene, Some(&surface), branch.kin, local);
    // Most of what is glass is.
    if local != Color::<Radiance>::BLACK {
        *radiance = radiance.plus(branch.kin.weight.weigh(local));
    }
    surface.branches()
        && branch.kin.generation < scene.settings.max_depth
        && follow(&surface, &scene.settings, branch, stack)
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
        material: surface.map(|surface| surface.material(scene)),
        inside: surface.is_some_and(Surface::inside),
        local: local.brightened(scene.settings.exposure.into()),
    });
}

/// Turns a branch into the one that follows from its hit, and puts off what
/// else follows; false if nothing does.
#[inline(always)]
fn follow(
    surface: &Surface<'_>,
    settings: &Settings,
    branch: &mut Branch,
    stack: &mut Stack,
) -> bool {
    let from = branch.kin;
    let Shares {
        mirrored,
        transmitted,
    } = surface.shares();
    let mut goes_on = false;
    if let Some((share, direction)) = transmitted
        && let Some(kin) = from.child(share, RayKind::Transmitted, settings)
    {
        let ray = surface.transmitted(direction);
        *branch = Branch { ray, kin };
        goes_on = true;
    }
    let Some(kin) = from.child(mirrored, RayKind::Reflected, settings) else {
        return goes_on;
    };
    if goes_on {
        // There is room, as said above; no branch is lost.
        let _ = stack.push(*branch);
    }
    branch.ray = surface.reflected();
    branch.kin = kin;
    true
}

/// What a ray that hits nothing brings back.
#[inline(never)]
fn background(settings: &Settings, height: Unit) -> Color<Radiance> {
    if height <= 0 || !settings.is_gradient() {
        return settings.horizon.into();
    }
    settings.horizon.zip(settings.zenith, |horizon, zenith| {
        let rise = i32::from(zenith.to_bits()) - i32::from(horizon.to_bits());
        // Q15 * Q30 -> Q30
        let risen = round_unit(rise.product(height.to_bits()), 15).to_bits();
        Radiance::from_bits((u32::from(horizon.to_bits()) << 15).saturating_add_signed(risen))
    })
}
