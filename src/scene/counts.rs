/// Numbers of objects, lights and materials: those of a scene, or the capacities of a
/// [`SceneBuffer`](crate::SceneBuffer).
///
/// [`scene_buffer!`](crate::scene_buffer!) returns the type of a buffer that has the given
/// counts as its capacities. A program that uses this macro still compiles when a new version
/// of the crate adds a kind of item.
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
    /// The counts of an empty scene.
    pub const EMPTY: Self = Self {
        objects: 0,
        lights: 0,
        materials: 0,
    };

    /// Returns these counts, but with the given number of objects.
    pub const fn objects(self, objects: usize) -> Self {
        Self { objects, ..self }
    }

    /// Returns these counts, but with the given number of lights.
    pub const fn lights(self, lights: usize) -> Self {
        Self { lights, ..self }
    }

    /// Returns these counts, but with the given number of materials.
    pub const fn materials(self, materials: usize) -> Self {
        Self { materials, ..self }
    }

    /// For each kind of item, returns the larger of the two counts. A buffer with these capacities
    /// can hold either of the two scenes.
    pub const fn max(self, other: Self) -> Self {
        Self {
            objects: larger(self.objects, other.objects),
            lights: larger(self.lights, other.lights),
            materials: larger(self.materials, other.materials),
        }
    }
}

/// Returns the larger of two numbers. `Ord::max` cannot be used because it is not `const`.
const fn larger(a: usize, b: usize) -> usize {
    if a > b { a } else { b }
}
