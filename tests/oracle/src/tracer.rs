//! Ray tree, traced by plain recursion.

use crate::Float;
use crate::ray::{Interval, Ray, SurfaceId};
use crate::scene::{Axis, Background, Cover, Light, Material, Model, Object, Scene};
use crate::vec3::{Color, Vec3};
use crate::view::View;

/// Closest crossing of a ray.
struct Hit<F> {
    t: F,
    surface: SurfaceId<F>,
}

/// Point, normal and incoming direction of a hit, for shading.
struct Interaction<F> {
    point: Vec3<F>,
    /// Unit normal on the side of the incoming ray.
    normal: Vec3<F>,
    /// Direction V of the incoming ray.
    incoming: Vec3<F>,
    /// −V·n, not negative.
    cosine: F,
    surface: SurfaceId<F>,
}

impl<F: Float> Interaction<F> {
    /// Returns the secondary ray in a direction.
    fn ray(&self, direction: Vec3<F>) -> Ray<F> {
        Ray {
            origin: self.point,
            direction,
            start: Some(self.surface),
        }
    }

    /// Returns the direction of mirror reflection.
    fn reflected(&self) -> Vec3<F> {
        self.incoming + self.normal * (self.cosine + self.cosine)
    }

    /// Returns the refracted direction, or `None` for total internal reflection. `eta`
    /// is n₁/n₂, with n₁ on the side of the incoming ray.
    fn refracted(&self, eta: F) -> Option<Vec3<F>> {
        let k = F::ONE - eta * eta * (F::ONE - self.cosine * self.cosine);
        if k < F::ZERO {
            return None;
        }
        Some(self.incoming * eta + self.normal * (eta * self.cosine - k.sqrt()))
    }
}

impl<F: Float> Scene<'_, F> {
    /// Returns the unclipped linear color of the pixel (x, y). Row 0 is at the top.
    pub fn pixel(&self, view: &View<F>, x: u32, y: u32) -> Color<F> {
        let mut budget = self.settings.ray_budget;
        self.trace(&view.ray(x, y), Color::ONE, 0, &mut budget)
    }

    /// Returns the radiance along a ray. `weight` is the fraction that reaches the eye,
    /// `depth` the number of bounces before, `budget` the rays left for the pixel.
    fn trace(&self, ray: &Ray<F>, weight: Color<F>, depth: u32, budget: &mut u32) -> Color<F> {
        if *budget == 0 {
            return Color::ZERO;
        }
        *budget -= 1;
        let Some(hit) = self.closest_hit(ray) else {
            return self.background(ray.direction);
        };
        let object = &self.objects[hit.surface.object];
        let point = ray.at(hit.t);
        let outward = object.shape.normal(point, hit.surface.center);
        let cosine = outward.dot(ray.direction);
        let is_leaving = cosine > F::ZERO;
        let interaction = Interaction {
            point,
            normal: if is_leaving { -outward } else { outward },
            incoming: ray.direction,
            cosine: cosine.abs(),
            surface: hit.surface,
        };
        let material = self.material(object, point);
        let mut color = self.shade(&interaction, material);
        if depth == self.settings.max_depth {
            return color;
        }
        // Traces a secondary ray, unless its weight is too small.
        let mut trace_branch = |direction: Vec3<F>, coefficient: Color<F>| {
            let weight = weight.times(coefficient);
            let greatest = weight.greatest();
            if greatest > F::ZERO && greatest >= self.settings.min_weight {
                let radiance = self.trace(&interaction.ray(direction), weight, depth + 1, budget);
                color = color + radiance.times(coefficient);
            }
        };
        if material.kt.is_zero() {
            trace_branch(interaction.reflected(), material.kr);
            return color;
        }
        let eta = match (object.shape.has_interior(), is_leaving) {
            (false, _) => F::ONE,
            (true, true) => material.ior,
            (true, false) => F::ONE / material.ior,
        };
        if let Some(refracted) = interaction.refracted(eta) {
            trace_branch(interaction.reflected(), material.kr);
            trace_branch(refracted, material.kt);
        } else {
            trace_branch(interaction.reflected(), Color::ONE);
        }
        color
    }

    #[inline(never)]
    fn closest_hit(&self, ray: &Ray<F>) -> Option<Hit<F>> {
        let mut interval = Interval {
            near: self.settings.epsilon,
            far: F::INFINITY,
        };
        let mut hit = None;
        for (index, object) in self.objects.iter().enumerate() {
            let start = ray.start_on(index);
            object
                .shape
                .crossings(ray, start, &mut interval, &mut |t, center| {
                    let surface = SurfaceId {
                        object: index,
                        center,
                    };
                    hit = Some(Hit { t, surface });
                    t
                });
        }
        hit
    }

    /// Returns emission, ambient light and direct lighting.
    fn shade(&self, interaction: &Interaction<F>, material: &Material<F>) -> Color<F> {
        let mut color = material.le + material.ka.times(self.settings.ambient);
        if material.kd.is_zero() && material.ks.is_zero() {
            return color;
        }
        for light in self.lights {
            let to_light = light.position - interaction.point;
            if to_light.dot(interaction.normal) <= F::ZERO {
                continue;
            }
            let distance = to_light.length();
            let to_light = to_light * (F::ONE / distance);
            let transmittance = self.transmittance(&interaction.ray(to_light), distance);
            if !transmittance.is_zero() {
                color = color
                    + transmittance.times(direct_lighting(interaction, material, light, to_light));
            }
        }
        color
    }

    /// Returns the transmittance between the start of a ray and a light at this
    /// distance: the product of `kt` of all surfaces between them.
    #[inline(never)]
    fn transmittance(&self, ray: &Ray<F>, distance: F) -> Color<F> {
        let mut interval = Interval {
            near: self.settings.epsilon,
            far: distance,
        };
        let mut transmittance = Color::ONE;
        for (index, object) in self.objects.iter().enumerate() {
            let start = ray.start_on(index);
            object
                .shape
                .crossings(ray, start, &mut interval, &mut |t, _| {
                    let kt = self.material_at(object, || ray.at(t)).kt;
                    transmittance = transmittance.times(kt);
                    if transmittance.is_zero() {
                        F::ZERO
                    } else {
                        distance
                    }
                });
            if transmittance.is_zero() {
                break;
            }
        }
        transmittance
    }

    fn background(&self, direction: Vec3<F>) -> Color<F> {
        match self.settings.background {
            Background::Solid(color) => color,
            Background::Gradient { horizon, zenith } => {
                let height = if direction.y > F::ONE {
                    F::ONE
                } else {
                    direction.y.max(F::ZERO)
                };
                horizon + (zenith - horizon) * height
            }
        }
    }

    fn material(&self, object: &Object<F>, point: Vec3<F>) -> &Material<F> {
        self.material_at(object, || point)
    }

    /// Returns the material of an object at a point. Calls `point` for checkerboards
    /// only.
    #[inline]
    fn material_at(&self, object: &Object<F>, point: impl FnOnce() -> Vec3<F>) -> &Material<F> {
        match object.cover {
            Cover::Material(index) => &self.materials[index],
            Cover::Checker {
                size,
                axes,
                materials,
            } => {
                let point = point();
                let [a, b] = axes.map(|axis| {
                    let coordinate = match axis {
                        Axis::X => point.x,
                        Axis::Y => point.y,
                        Axis::Z => point.z,
                    };
                    (coordinate / size).floor()
                });
                // The sum is odd if the lowest bits of its terms differ.
                let odd = (a ^ b) & 1;
                &self.materials[materials[odd as usize]]
            }
        }
    }
}

/// Returns the diffuse and specular terms of a light on the normal's side of the
/// surface. `to_light` is the unit vector L.
fn direct_lighting<F: Float>(
    interaction: &Interaction<F>,
    material: &Material<F>,
    light: &Light<F>,
    to_light: Vec3<F>,
) -> Color<F> {
    let n_dot_l = to_light.dot(interaction.normal);
    let diffuse = material.kd.times(light.diffuse) * n_dot_l;
    if material.ks.is_zero() {
        return diffuse;
    }
    let v_dot_l = to_light.dot(interaction.incoming);
    let cosine = match material.model {
        // R_L·(−V), with R_L = 2(L·n)n − L expanded.
        Model::Phong => (n_dot_l + n_dot_l) * interaction.cosine + v_dot_l,
        // H·n, with H = (L − V) / |L − V| and |L − V| = √(2 − 2·L·V).
        Model::BlinnPhong => {
            let length2 = F::lit(2.0) - (v_dot_l + v_dot_l);
            (n_dot_l + interaction.cosine) / length2.sqrt()
        }
    };
    if cosine <= F::ZERO {
        return diffuse;
    }
    diffuse + material.ks.times(light.specular) * cosine.pow(material.shininess)
}
