/// Numbers of items of a scene, or the capacity of a [`SceneBuffer`](crate::SceneBuffer).
///
/// [`scene_buffer!`](crate::scene_buffer) turns counts into the type of a buffer that holds as
/// many, so a program that uses both need not change when scenes get new kinds of items.
///
/// ```
/// use whitted::scene::SceneCounts;
///
/// const COUNTS: SceneCounts = SceneCounts::EMPTY.objects(64).lights(8).materials(64);
/// type Buffer = whitted::scene_buffer!(COUNTS);
/// static mut BUFFER: Buffer = Buffer::new();
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct SceneCounts {
    /// Number of objects.
    pub objects: usize,
    /// Number of lights.
    pub lights: usize,
    /// Number of materials.
    pub materials: usize,
}

impl SceneCounts {
    /// No items.
    pub const EMPTY: Self = Self {
        objects: 0,
        lights: 0,
        materials: 0,
    };

    /// These counts with another number of objects.
    pub const fn objects(self, objects: usize) -> Self {
        Self { objects, ..self }
    }

    /// These counts with another number of lights.
    pub const fn lights(self, lights: usize) -> Self {
        Self { lights, ..self }
    }

    /// These counts with another number of materials.
    pub const fn materials(self, materials: usize) -> Self {
        Self { materials, ..self }
    }

    /// The larger of both counts of each kind: the capacity that holds either scene.
    pub const fn max(self, other: Self) -> Self {
        Self {
            objects: larger(self.objects, other.objects),
            lights: larger(self.lights, other.lights),
            materials: larger(self.materials, other.materials),
        }
    }
}

/// `Ord::max` is not const.
const fn larger(a: usize, b: usize) -> usize {
    if a > b { a } else { b }
}
