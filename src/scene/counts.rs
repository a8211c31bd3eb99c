/// Numbers of items of a scene, or capacities of a [`SceneBuffer`](crate::SceneBuffer).
///
/// [`scene_buffer!`](crate::scene_buffer) turns counts into the type of a buffer with these
/// capacities, so a program that uses both keeps compiling when scenes get new kinds of items.
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
    /// Counts of an empty scene.
    pub const EMPTY: Self = Self {
        objects: 0,
        lights: 0,
        materials: 0,
    };

    /// Returns these counts with another number of objects.
    pub const fn objects(self, objects: usize) -> Self {
        Self { objects, ..self }
    }

    /// Returns these counts with another number of lights.
    pub const fn lights(self, lights: usize) -> Self {
        Self { lights, ..self }
    }

    /// Returns these counts with another number of materials.
    pub const fn materials(self, materials: usize) -> Self {
        Self { materials, ..self }
    }

    /// Returns the larger of both counts for each kind of item: capacities that hold either scene.
    pub const fn max(self, other: Self) -> Self {
        Self {
            objects: larger(self.objects, other.objects),
            lights: larger(self.lights, other.lights),
            materials: larger(self.materials, other.materials),
        }
    }
}

/// Returns the larger number. (`Ord::max` is not `const`.)
const fn larger(a: usize, b: usize) -> usize {
    if a > b { a } else { b }
}
