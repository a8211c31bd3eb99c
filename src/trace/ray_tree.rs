//! Traces the ray tree of a pixel (Whitted 1980). The tree is traversed with an explicit stack.

use heapless::{Vec, VecView};

use super::background::background;
use super::candidates::Candidates;
use super::interaction::Interaction;
use super::scatter::Scattering;
use super::tracer::Tracer;
use crate::geometry::{OriginSurface, Point, Ray};
use crate::math::{Color, Factor, Radiance, Unit, Vec3, Weight};
use crate::observer::{Observer, RayKind, RayNode, weight_to_real};
use crate::prepare::{MAX_DEPTH, Settings};

/// Maximum number of rays per pixel, not counting shadow rays. Further rays of the pixel are not
/// traced and count as black.
///
/// Without this limit, a ray tree of the greatest depth, 32, could have 2^33 rays.
const RAY_BUDGET: u16 = 4096;

/// Capacity of the small stack of rays. A scene uses this stack if its `max_depth` is at most this
/// capacity.
const SMALL_STACK: usize = 8;

/// A ray that still has to be traced. It takes 56 bytes.
#[derive(Clone, Copy, Debug)]
struct PendingRay {
    ray: Ray,
    path: PathState,
}

/// State of the path from the camera to a ray.
#[derive(Clone, Copy, Debug)]
struct PathState {
    /// Fraction of the ray's radiance that reaches the camera.
    throughput: Color<Weight>,
    /// Number of reflections and transmissions between the camera and the ray.
    depth: u8,
    kind: RayKind,
}

impl PathState {
    const CAMERA: Self = Self {
        throughput: Color::<Weight>::ALL,
        depth: 0,
        kind: RayKind::Camera,
    };

    /// Extends the path by a ray with the given weight. Returns `None` if the throughput of the
    /// extended path is too small to matter.
    fn extended(&self, weight: Color<Weight>, kind: RayKind, settings: &Settings) -> Option<Self> {
        // Before the first reflection or refraction, the throughput is 1. The new throughput is
        // therefore the weight.
        let throughput = if self.depth == 0 {
            weight
        } else {
            self.throughput.shared(weight)
        };
        let too_small =
            u32::from(settings.min_weight.saturating_sub(Factor::DELTA).to_bits()) << 15;
        let counts = !throughput.all(|w| w.to_bits() <= too_small);
        counts.then_some(Self {
            throughput,
            depth: self.depth + 1,
            kind,
        })
    }
}

impl<'s, O: Observer> Tracer<'_, 's, O> {
    /// Traces a camera ray and returns its radiance.
    ///
    /// The direction may have any length. It is normalized only where necessary. For example,
    /// planes with matte materials do not need a unit direction.
    ///
    /// This function is not inlined, so that all ways to draw share one copy of the tracer.
    #[inline(never)]
    pub(crate) fn trace_camera_ray(
        &mut self,
        direction: Vec3<Unit>,
        candidates: &mut Candidates,
    ) -> Color<Radiance> {
        self.observer.ray(RayKind::Camera);
        let radiance = if let Some([]) = candidates.objects() {
            self.shade_background(direction, candidates)
        } else {
            self.trace_candidates(direction, candidates)
        };
        let exposure = self.scene.settings.exposure;
        if exposure == 0 {
            return radiance;
        }
        radiance.brightened(exposure.into())
    }

    fn trace_candidates(
        &mut self,
        direction: Vec3<Unit>,
        candidates: &mut Candidates,
    ) -> Color<Radiance> {
        let scene = self.scene;
        let interaction = &mut Interaction::new(Ray {
            origin: Point::near(scene.settings.camera.eye),
            direction,
            leaves: OriginSurface::NONE,
        });
        let cached = candidates.cached_hit;
        let hit = if let Some(hit) = cached {
            hit
        } else {
            if !candidates.are_planes {
                interaction.ray.direction = interaction.ray.direction.unit();
            }
            let hit = match candidates.objects() {
                Some(objects) => self.intersect_candidates(objects, &interaction.ray),
                None => self.intersect_any(&interaction.ray),
            };
            let Some(hit) = hit else {
                return self.shade_background(interaction.ray.direction, candidates);
            };
            candidates.cache(hit);
            hit
        };
        if !interaction.advance(scene, hit, self.part, cached.is_some()) {
            return self.shade_background(interaction.ray.direction, candidates);
        }
        if candidates.are_planes && !interaction.is_matte() {
            interaction.normalize_ray();
        }
        let mut radiance = Color::<Radiance>::BLACK;
        self.direct_lighting(interaction, &mut radiance);
        self.notify(Some(interaction), PathState::CAMERA, radiance);
        if interaction.material.is_specular && scene.settings.max_depth > 0 {
            self.trace_tree(interaction, &mut radiance);
        }
        radiance
    }

    /// Returns the radiance of a camera ray that hits nothing.
    fn shade_background(
        &mut self,
        direction: Vec3<Unit>,
        candidates: &mut Candidates,
    ) -> Color<Radiance> {
        candidates.is_miss = true;
        let settings = &self.scene.settings;
        let height = if candidates.are_planes && settings.is_gradient {
            direction.unit_outlined().y
        } else {
            direction.y
        };
        let radiance = background(settings, height);
        self.notify(None, PathState::CAMERA, radiance);
        radiance
    }

    /// Adds the radiance of all secondary rays of a pixel. The stack of pending rays has a capacity
    /// that depends on the depth of the scene.
    fn trace_tree(&mut self, interaction: &mut Interaction<'s>, radiance: &mut Color<Radiance>) {
        let settings = &self.scene.settings;
        let mut tree = RayTree {
            tracer: self,
            interaction,
            path: PathState::CAMERA,
            radiance,
        };
        if !cfg!(feature = "glass") || settings.is_opaque {
            tree.trace_reflections();
        } else if usize::from(settings.max_depth) <= SMALL_STACK {
            tree.trace_with_stack::<SMALL_STACK>();
        } else {
            tree.trace_with_stack::<{ MAX_DEPTH as usize }>();
        }
    }

    /// Reports a node of the ray tree to the observer.
    fn notify(
        &mut self,
        interaction: Option<&Interaction<'_>>,
        path: PathState,
        local: Color<Radiance>,
    ) {
        if !O::OBSERVES_NODES {
            return;
        }
        let scene = self.scene;
        let material = |it: &Interaction<'_>| {
            let object = scene.object(it.object());
            object.texture.material(&it.ray.origin)
        };
        self.observer.node(&RayNode {
            kind: path.kind,
            generation: path.depth,
            weight: weight_to_real(path.throughput),
            object: interaction.map(Interaction::object),
            material: interaction.map(material),
            inside: interaction.is_some_and(Interaction::is_inside),
            local: local.brightened(scene.settings.exposure.into()),
        });
    }
}

/// Traversal of a ray tree. It holds the current ray and the radiance that has been found so
/// far.
struct RayTree<'r, 't, 's, O> {
    tracer: &'r mut Tracer<'t, 's, O>,
    interaction: &'r mut Interaction<'s>,
    path: PathState,
    radiance: &'r mut Color<Radiance>,
}

impl<O: Observer> RayTree<'_, '_, '_, O> {
    /// Traces the reflected rays of a scene without transparent materials. In such a scene, each
    /// ray has at most one successor.
    fn trace_reflections(&mut self) {
        let stack = &mut Vec::<PendingRay, 0>::new();
        let mut has_next = self.reflect();
        while has_next && !self.tracer.observer.is_interrupted() {
            has_next = self.trace_node(stack);
        }
    }

    #[inline(never)]
    fn trace_with_stack<const CAPACITY: usize>(&mut self) {
        self.trace_all(&mut Vec::<PendingRay, CAPACITY>::new());
    }

    #[inline(never)]
    fn trace_all(&mut self, stack: &mut VecView<PendingRay>) {
        let mut has_next = self.scatter(stack);
        for _ in 1..RAY_BUDGET {
            if self.tracer.observer.is_interrupted() {
                return;
            }
            if !has_next {
                let Some(next) = stack.pop() else {
                    return;
                };
                self.interaction.ray = next.ray;
                self.path = next.path;
            }
            has_next = self.trace_node(stack);
        }
    }

    /// Traces the current ray, adds its radiance, and replaces the ray by its successor.
    /// Returns false if the ray has no successor.
    #[inline(never)]
    fn trace_node(&mut self, stack: &mut VecView<PendingRay>) -> bool {
        let Self {
            tracer,
            interaction,
            path,
            radiance,
        } = self;
        let scene = tracer.scene;
        tracer.observer.ray(path.kind);
        let Some(hit) = tracer.intersect(&interaction.ray) else {
            let background = background(&scene.settings, interaction.ray.direction.y);
            tracer.notify(None, *path, background);
            **radiance = radiance.plus(path.throughput.weigh(background));
            return false;
        };
        interaction.advance(scene, hit, tracer.part, false);
        let mut local = Color::<Radiance>::BLACK;
        tracer.direct_lighting(interaction, &mut local);
        tracer.notify(Some(interaction), *path, local);
        // The direct lighting of glass is usually black. Black need not be added.
        if local != Color::<Radiance>::BLACK {
            **radiance = radiance.plus(path.throughput.weigh(local));
        }
        interaction.material.is_specular
            && path.depth < scene.settings.max_depth
            && self.scatter(stack)
    }

    /// Replaces the current ray by its successor. If the ray has two successors, the second is
    /// pushed onto the stack. Returns false if the ray has no successor.
    fn scatter(&mut self, stack: &mut VecView<PendingRay>) -> bool {
        if !cfg!(feature = "glass") || self.interaction.material.kt.is_black() {
            return self.reflect();
        }
        self.reflect_and_transmit(stack)
    }

    /// Replaces the current ray by the reflected ray. Returns false if the reflected ray need
    /// not be traced.
    fn reflect(&mut self) -> bool {
        let weight = self.interaction.material.kr;
        let settings = &self.tracer.scene.settings;
        let Some(path) = self.path.extended(weight, RayKind::Reflected, settings) else {
            return false;
        };
        self.interaction.reflect();
        self.path = path;
        true
    }

    /// Chooses the rays to trace from the reflected and the transmitted ray. If only one of them is
    /// worth tracing, it replaces the current ray. If both are worth tracing, the reflected ray
    /// replaces the current ray, and the transmitted ray is pushed onto the stack. The stack
    /// therefore holds at most one ray per generation, and no push fails. Returns false if neither
    /// is worth tracing.
    #[inline(never)]
    fn reflect_and_transmit(&mut self, stack: &mut VecView<PendingRay>) -> bool {
        let Self {
            tracer,
            interaction,
            path,
            ..
        } = self;
        let settings = &tracer.scene.settings;
        let Scattering {
            reflected,
            transmitted,
        } = interaction.scatter();
        let transmitted = transmitted.and_then(|(weight, direction)| {
            let path = path.extended(weight, RayKind::Transmitted, settings)?;
            let ray = interaction.transmitted_ray(direction);
            Some(PendingRay { ray, path })
        });
        let reflected = path.extended(reflected, RayKind::Reflected, settings);
        match (transmitted, reflected) {
            (None, None) => return false,
            (Some(transmitted), None) => {
                interaction.ray = transmitted.ray;
                *path = transmitted.path;
            }
            (transmitted, Some(reflected)) => {
                if let Some(transmitted) = transmitted {
                    let _ = stack.push(transmitted);
                }
                interaction.reflect();
                *path = reflected;
            }
        }
        true
    }
}
