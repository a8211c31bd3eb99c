use heapless::Vec;
use postcard::{Error, take_from_bytes};
use serde::de::DeserializeOwned;
use whitted_oracle::{Light, Material, Object, Scene};

/// Memory for the lights, materials and objects of a scene.
pub(crate) struct SceneStorage {
    lights: Vec<Light<f32>, 8>,
    materials: Vec<Material<f32>, 64>,
    objects: Vec<Object<f32>, 64>,
}

impl SceneStorage {
    pub(crate) const EMPTY: Self = Self {
        lights: Vec::new(),
        materials: Vec::new(),
        objects: Vec::new(),
    };

    /// Decodes a scene from `bytes`, which hold the fields of [`Scene`] in declaration
    /// order.
    ///
    /// # Errors
    /// Returns an error if the data is malformed or a list exceeds its capacity.
    pub(crate) fn decode(&mut self, bytes: &[u8]) -> Result<Scene<'_, f32>, Error> {
        let (camera, bytes) = take_from_bytes(bytes)?;
        let (settings, bytes) = take_from_bytes(bytes)?;
        let bytes = read_list(&mut self.lights, bytes)?;
        let bytes = read_list(&mut self.materials, bytes)?;
        read_list(&mut self.objects, bytes)?;
        Ok(Scene {
            camera,
            settings,
            lights: &self.lights,
            materials: &self.materials,
            objects: &self.objects,
        })
    }
}

/// Reads a list from the start of `bytes` and returns the bytes after the list.
///
/// The items are read one by one. Decoding the whole list at once would need stack space
/// for all items.
fn read_list<'b, T, const N: usize>(
    list: &mut Vec<T, N>,
    bytes: &'b [u8],
) -> Result<&'b [u8], Error>
where
    T: DeserializeOwned,
{
    let (count, mut bytes) = take_from_bytes::<u32>(bytes)?;
    for _ in 0..count {
        let (item, rest) = take_from_bytes(bytes)?;
        list.push(item).map_err(|_| Error::SerializeBufferFull)?;
        bytes = rest;
    }
    Ok(bytes)
}
