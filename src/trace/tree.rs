//! The tree of rays of a pixel (Whitted 1980), walked by an explicit stack.

use heapless::{Vec, VecView};

use crate::geometry::{OriginSurface, Point, Ray};
use crate::math::{Color, Factor, Product, Radiance, Unit, Vec3, Weight, round_unit};
use crate::observer::{Observer, RayKind, RayNode, ShapeKind, weight};
use crate::prepare::{MAX_DEPTH, PreparedScene, Settings};
use crate::trace::intersect::PrimitivePart;
use crate::trace::shade::{Shares, Surface};
use crate::trace::{Candidates, intersect};

/// Rays of one pixel, shadow rays apart, after which branches add black.
///
/// Depth alone allows 2^33.
pub(crate) const RAY_BUDGET: u16 = 4096;

/// A ray still to be traced.
#[derive(Clone, Copy, Debug)]
struct PendingRay {
    ray: Ray,
    kin: PathState,
}

/// Where a ray stands in the tree.
#[derive(Clone, Copy, Debug)]
struct PathState {
    /// How much of what it brings back reaches the eye.
    weight: Color<Weight>,
    generation: u8,
    kind: RayKind,
}

impl PathState {
    const CAMERA: Self = Self {
        weight: Color::<Weight>::ALL,
        generation: 0,
        kind: RayKind::Camera,
    };

    /// A ray that follows with a share of the weight, if that counts.
    #[inline(always)]
    fn child(&self, share: Color<Weight>, kind: RayKind, settings: &Settings) -> Option<Self> {
        // All but the last step of what an eye ray has is the share itself.
        let weight = if self.generation == 0 {
            share
        } else {
            self.weight.shared(share)
        };
        let too_little =
            u32::from(settings.min_weight.saturating_sub(Factor::DELTA).to_bits()) << 15;
        let counts = !weight.all(|w| w.to_bits() <= too_little);
        counts.then_some(Self {
            weight,
            generation: self.generation + 1,
            kind,
        })
    }
}

/// Branches put off: a transmitted ray waits while the reflected one beside
/// it is followed, so there is at most one for each generation. Room for few of them is
/// room enough for most scenes.
const FEW: usize = 8;

/// The radiance that an eye ray brings back, of which candidates are known. Its
/// direction is made a unit vector if need be: planes and what
/// they reflect diffusely can do without.
///
/// Not inlined: there is one copy of all tracing, whatever it is drawn into.
#[inline(never)]
pub(crate) fn trace(
    scene: &PreparedScene<'_>,
    direction: Vec3<Unit>,
    candidates: &mut Candidates,
    part: &mut PrimitivePart,
    observer: &mut impl Observer,
) -> Color<Radiance> {
    observer.ray(RayKind::Camera);
    let radiance = if let Some([]) = candidates.objects() {
        missed(scene, direction, candidates, observer)
    } else {
        let ray = Ray {
            origin: Point::near(scene.settings.camera.eye),
            direction,
            start: OriginSurface::NOWHERE,
        };
        look(scene, ray, candidates, part, observer)
    };
    if scene.settings.exposure == 0 {
        return radiance;
    }
    radiance.brightened(scene.settings.exposure.into())
}

/// The same for a ray that may meet something.
#[inline(always)]
fn look(
    scene: &PreparedScene<'_>,
    ray: Ray,
    candidates: &mut Candidates,
    part: &mut PrimitivePart,
    observer: &mut impl Observer,
) -> Color<Radiance> {
    let surface = &mut Surface::ahead_of(ray);
    let known = candidates.met;
    let hit = if let Some(hit) = known {
        hit
    } else {
        if !candidates.are_flat {
            surface.make_unit();
        }
        let hit = match candidates.objects() {
            Some(objects) => intersect::nearest_of(objects, scene, surface.ray(), part, observer),
            None => intersect::nearest_of_many(scene, surface.ray(), part, observer),
        };
        let Some(hit) = hit else {
            return missed(scene, surface.ray().direction, candidates, observer);
        };
        candidates.keep(hit);
        hit
    };
    if !surface.meet_if_there(scene, hit, part, known.is_none()) {
        observer.test(ShapeKind::Plane, false);
        return missed(scene, surface.ray().direction, candidates, observer);
    }
    if candidates.are_flat && !surface.is_matte() {
        surface.look_closely();
    }
    let mut radiance = Color::<Radiance>::BLACK;
    surface.local(scene, &mut radiance, observer);
    tell(observer, scene, Some(surface), PathState::CAMERA, radiance);
    if surface.branches() && scene.settings.max_depth > 0 {
        let mut walk = Walk {
            surface,
            kin: PathState::CAMERA,
            radiance: &mut radiance,
        };
        if scene.settings.is_opaque {
            walk.climb_among_mirrors(scene, part, observer);
        } else if usize::from(scene.settings.max_depth) <= FEW {
            walk.climb_through_glass::<FEW>(scene, part, observer);
        } else {
            walk.climb_through_glass::<{ MAX_DEPTH as usize }>(scene, part, observer);
        }
    }
    radiance
}

/// The same for a ray that hits nothing.
#[inline(always)]
fn missed(
    scene: &PreparedScene<'_>,
    direction: Vec3<Unit>,
    candidates: &Candidates,
    observer: &mut impl Observer,
) -> Color<Radiance> {
    let height = if candidates.are_flat && scene.settings.is_gradient {
        direction.unit_of_few().y
    } else {
        direction.y
    };
    let radiance = background(&scene.settings, height);
    tell(observer, scene, None, PathState::CAMERA, radiance);
    radiance
}

/// A walk through the tree of rays: where it is, and what it found.
struct Walk<'w, 's> {
    surface: &'w mut Surface<'s>,
    kin: PathState,
    radiance: &'w mut Color<Radiance>,
}

impl<'s> Walk<'_, 's> {
    /// Adds what all the rays bring back that go on from where the eye ray hit.
    #[inline(never)]
    fn climb(
        &mut self,
        scene: &PreparedScene<'s>,
        waiting: &mut VecView<PendingRay>,
        part: &mut PrimitivePart,
        observer: &mut impl Observer,
    ) {
        let mut goes_on = self.follow(&scene.settings, waiting);
        for _ in 1..RAY_BUDGET {
            if !goes_on {
                let Some(next) = waiting.pop() else {
                    return;
                };
                self.surface.follow(next.ray);
                self.kin = next.kin;
            }
            goes_on = self.visit(scene, waiting, part, observer);
        }
    }

    /// The same where rays may have to wait, which takes 56 bytes of stack for each.
    #[inline(never)]
    fn climb_through_glass<const ROOM: usize>(
        &mut self,
        scene: &PreparedScene<'s>,
        part: &mut PrimitivePart,
        observer: &mut impl Observer,
    ) {
        self.climb(scene, &mut Vec::<PendingRay, ROOM>::new(), part, observer);
    }

    /// The same where nothing lets light through: one ray follows another.
    #[inline(always)]
    fn climb_among_mirrors(
        &mut self,
        scene: &PreparedScene<'s>,
        part: &mut PrimitivePart,
        observer: &mut impl Observer,
    ) {
        let waiting = &mut Vec::<PendingRay, 0>::new();
        let mut goes_on = self.mirror(&scene.settings);
        while goes_on {
            goes_on = self.visit(scene, waiting, part, observer);
        }
    }

    /// Traces a ray, adds what it brings back, and sends the one on its way that
    /// follows; false if none does.
    #[inline(never)]
    fn visit(
        &mut self,
        scene: &PreparedScene<'s>,
        waiting: &mut VecView<PendingRay>,
        part: &mut PrimitivePart,
        observer: &mut impl Observer,
    ) -> bool {
        let Self {
            surface,
            kin,
            radiance,
        } = self;
        observer.ray(kin.kind);
        let Some(hit) = intersect::nearest(scene, surface.ray(), part, observer) else {
            let background = background(&scene.settings, surface.ray().direction.y);
            tell(observer, scene, None, *kin, background);
            **radiance = radiance.plus(kin.weight.weigh(background));
            return false;
        };
        surface.meet(scene, hit, part);
        let mut local = Color::<Radiance>::BLACK;
        surface.local(scene, &mut local, observer);
        tell(observer, scene, Some(surface), *kin, local);
        // Most of what is glass is.
        if local != Color::<Radiance>::BLACK {
            **radiance = radiance.plus(kin.weight.weigh(local));
        }
        surface.branches()
            && kin.generation < scene.settings.max_depth
            && self.follow(&scene.settings, waiting)
    }

    /// Sends the ray on its way that follows from a hit, and puts off what else
    /// follows; false if nothing does.
    #[inline(always)]
    fn follow(&mut self, settings: &Settings, waiting: &mut VecView<PendingRay>) -> bool {
        if self.surface.is_opaque() {
            return self.mirror(settings);
        }
        self.part_ways(settings, waiting)
    }

    /// The same where nothing is put off.
    #[inline(always)]
    fn mirror(&mut self, settings: &Settings) -> bool {
        let share = self.surface.mirrored();
        let Some(kin) = self.kin.child(share, RayKind::Reflected, settings) else {
            return false;
        };
        self.surface.reflect();
        self.kin = kin;
        true
    }

    /// The same where light goes through.
    #[inline(never)]
    fn part_ways(&mut self, settings: &Settings, waiting: &mut VecView<PendingRay>) -> bool {
        let Self { surface, kin, .. } = self;
        let Shares {
            mirrored,
            transmitted,
        } = surface.shares();
        let through = transmitted.and_then(|(share, direction)| {
            let kin = kin.child(share, RayKind::Transmitted, settings)?;
            let ray = surface.transmitted(direction);
            Some(PendingRay { ray, kin })
        });
        let reflected = kin.child(mirrored, RayKind::Reflected, settings);
        match (through, reflected) {
            (None, None) => return false,
            (Some(through), None) => {
                surface.follow(through.ray);
                *kin = through.kin;
            }
            (through, Some(reflected)) => {
                if let Some(through) = through {
                    // There is room, as said above; no branch is lost.
                    let _ = waiting.push(through);
                }
                surface.reflect();
                *kin = reflected;
            }
        }
        true
    }
}

/// Tells of a node of the tree.
#[inline(always)]
fn tell(
    observer: &mut impl Observer,
    scene: &PreparedScene<'_>,
    surface: Option<&Surface<'_>>,
    kin: PathState,
    local: Color<Radiance>,
) {
    observer.node(&RayNode {
        kind: kin.kind,
        generation: kin.generation,
        weight: weight(kin.weight),
        object: surface.map(Surface::object),
        material: surface.map(|surface| surface.material(scene)),
        inside: surface.is_some_and(Surface::inside),
        local: local.brightened(scene.settings.exposure.into()),
    });
}

/// What a ray that hits nothing brings back.
#[inline(always)]
fn background(settings: &Settings, height: Unit) -> Color<Radiance> {
    if settings.is_gradient && height > 0 {
        return sky(settings, height);
    }
    settings.horizon
}

/// A gradient, at a height above the horizon.
#[inline(never)]
fn sky(settings: &Settings, height: Unit) -> Color<Radiance> {
    settings.horizon.zip(settings.zenith, |horizon, zenith| {
        // Both are 1 at most, and so is what is between.
        let rise = zenith.to_bits() as i32 - horizon.to_bits() as i32;
        let risen = round_unit::<30>(rise.product(height.to_bits())).to_bits();
        Radiance::from_bits(horizon.to_bits().saturating_add_signed(risen))
    })
}
