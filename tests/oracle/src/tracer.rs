//! The ray tree, walked by plain recursion.

use crate::Float;
use crate::ray::{Ray, Reach, Start};
use crate::scene::{Axis, Background, Cover, Light, Material, Model, Object, Scene};
use crate::vec3::{Color, Vec3};
use crate::view::View;

/// The nearest crossing of a ray: t alone, and on what.
struct Hit<F> {
    t: F,
    on: Start<F>,
}

/// A hit's surroundings, as shading needs them.
struct Place<F> {
    point: Vec3<F>,
    /// Turned to face the incoming ray.
    normal: Vec3<F>,
    /// The incoming ray's direction, V.
    incoming: Vec3<F>,
    /// −V·n, positive.
    cosine: F,
    on: Start<F>,
}

impl<F: Float> Place<F> {
    fn ray(&self, direction: Vec3<F>) -> Ray<F> {
        Ray {
            origin: self.point,
            direction,
            start: Some(self.on),
        }
    }

    fn reflected(&self) -> Vec3<F> {
        self.incoming + self.normal * (self.cosine + self.cosine)
    }

    /// None is total internal reflection. `eta` is n₁/n₂, from the ray's side
    /// to the other.
    fn refracted(&self, eta: F) -> Option<Vec3<F>> {
        let k = F::ONE - eta * eta * (F::ONE - self.cosine * self.cosine);
        if k < F::ZERO {
            return None;
        }
        Some(self.incoming * eta + self.normal * (eta * self.cosine - k.sqrt()))
    }
}

impl<F: Float> Scene<'_, F> {
    /// The linear color, not clipped, of the pixel at (x, y), row 0 on top.
    pub fn pixel(&self, view: &View<F>, x: u32, y: u32) -> Color<F> {
        let mut budget = self.settings.ray_budget;
        self.trace(&view.ray(x, y), Color::ONE, 0, &mut budget)
    }

    /// What a ray brings back. `weight` is the share that reaches the eye,
    /// `depth` the ray's generation, `budget` the rays that the pixel has left.
    fn trace(&self, ray: &Ray<F>, weight: Color<F>, depth: u32, budget: &mut u32) -> Color<F> {
        if *budget == 0 {
            return Color::ZERO;
        }
        *budget -= 1;
        let Some(hit) = self.nearest(ray) else {
            return self.background(ray.direction);
        };
        let object = &self.objects[hit.on.object];
        let point = ray.at(hit.t);
        let outward = object.shape.normal(point, hit.on.center);
        let along = outward.dot(ray.direction);
        let leaving = along > F::ZERO;
        let place = Place {
            point,
            normal: if leaving { -outward } else { outward },
            incoming: ray.direction,
            cosine: along.abs(),
            on: hit.on,
        };
        let material = self.material(object, point);
        let mut color = self.shade(&place, material);
        if depth == self.settings.max_depth {
            return color;
        }
        let mut follow = |direction: Vec3<F>, share: Color<F>| {
            let weight = weight.times(share);
            let greatest = weight.greatest();
            if greatest > F::ZERO && greatest >= self.settings.min_weight {
                let light = self.trace(&place.ray(direction), weight, depth + 1, budget);
                color = color + light.times(share);
            }
        };
        if material.kt.is_zero() {
            follow(place.reflected(), material.kr);
            return color;
        }
        let eta = match (object.shape.has_inside(), leaving) {
            (false, _) => F::ONE,
            (true, true) => material.ior,
            (true, false) => F::ONE / material.ior,
        };
        if let Some(refracted) = place.refracted(eta) {
            follow(place.reflected(), material.kr);
            follow(refracted, material.kt);
        } else {
            follow(place.reflected(), Color::ONE);
        }
        color
    }

    #[inline(never)]
    fn nearest(&self, ray: &Ray<F>) -> Option<Hit<F>> {
        let mut reach = Reach {
            near: self.settings.epsilon,
            far: F::INFINITY,
        };
        let mut hit = None;
        for (index, object) in self.objects.iter().enumerate() {
            let start = ray.start_on(index);
            object
                .shape
                .crossings(ray, start, &mut reach, &mut |t, center| {
                    let on = Start {
                        object: index,
                        center,
                    };
                    hit = Some(Hit { t, on });
                    t
                });
        }
        hit
    }

    /// The material's own light and each light source's, without the bounces.
    fn shade(&self, place: &Place<F>, material: &Material<F>) -> Color<F> {
        let mut color = material.le + material.ka.times(self.settings.ambient);
        if material.kd.is_zero() && material.ks.is_zero() {
            return color;
        }
        for light in self.lights {
            let to_light = light.position - place.point;
            if to_light.dot(place.normal) <= F::ZERO {
                continue;
            }
            let distance = to_light.length();
            let to_light = to_light * (F::ONE / distance);
            let through = self.transmittance(&place.ray(to_light), distance);
            if !through.is_zero() {
                color = color + through.times(lit(place, material, light, to_light));
            }
        }
        color
    }

    /// What the surfaces between the ray's start and a light at this distance
    /// let through.
    #[inline(never)]
    fn transmittance(&self, ray: &Ray<F>, distance: F) -> Color<F> {
        let mut reach = Reach {
            near: self.settings.epsilon,
            far: distance,
        };
        let mut through = Color::ONE;
        for (index, object) in self.objects.iter().enumerate() {
            let start = ray.start_on(index);
            object.shape.crossings(ray, start, &mut reach, &mut |t, _| {
                let kt = self.material_at(object, || ray.at(t)).kt;
                through = through.times(kt);
                if through.is_zero() { F::ZERO } else { distance }
            });
            if through.is_zero() {
                break;
            }
        }
        through
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

    /// The point is computed only where the cover asks for it.
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
                // A sum is odd where its terms' lowest bits differ.
                let odd = (a ^ b) & 1;
                &self.materials[materials[odd as usize]]
            }
        }
    }
}

/// The diffuse and specular terms of a light that shines on the surface's side.
/// `to_light` is the unit vector L.
fn lit<F: Float>(
    place: &Place<F>,
    material: &Material<F>,
    light: &Light<F>,
    to_light: Vec3<F>,
) -> Color<F> {
    let facing = to_light.dot(place.normal);
    let diffuse = material.kd.times(light.diffuse) * facing;
    if material.ks.is_zero() {
        return diffuse;
    }
    let with_view = to_light.dot(place.incoming);
    let base = match material.model {
        // R_L·(−V), with R_L = 2(L·n)n − L multiplied out.
        Model::Phong => (facing + facing) * place.cosine + with_view,
        // H·n, with H = unit(L − V), whose length before is √(2 − 2·L·V).
        Model::BlinnPhong => {
            let length2 = F::lit(2.0) - (with_view + with_view);
            (facing + place.cosine) / length2.sqrt()
        }
    };
    if base <= F::ZERO {
        return diffuse;
    }
    diffuse + material.ks.times(light.specular) * base.pow(material.shininess)
}
