use heapless::Vec;
use postcard::{Error, take_from_bytes};
use serde::de::DeserializeOwned;
use whitted_oracle::{Light, Material, Object, Scene};

/// Room for a scene's lists.
pub(crate) struct Room {
    lights: Vec<Light<f32>, 8>,
    materials: Vec<Material<f32>, 64>,
    objects: Vec<Object<f32>, 64>,
}

impl Room {
    pub(crate) const EMPTY: Self = Self {
        lights: Vec::new(),
        materials: Vec::new(),
        objects: Vec::new(),
    };

    /// Reads the fields of [`Scene`], in their order.
    pub(crate) fn decode(&mut self, bytes: &[u8]) -> Result<Scene<'_, f32>, Error> {
        let (camera, bytes) = take_from_bytes(bytes)?;
        let (settings, bytes) = take_from_bytes(bytes)?;
        let bytes = read(&mut self.lights, bytes)?;
        let bytes = read(&mut self.materials, bytes)?;
        read(&mut self.objects, bytes)?;
        Ok(Scene {
            camera,
            settings,
            lights: &self.lights,
            materials: &self.materials,
            objects: &self.objects,
        })
    }
}

/// One by one, as a whole list would pass through the stack. Answers what
/// follows it.
fn read<'b, T, const N: usize>(list: &mut Vec<T, N>, bytes: &'b [u8]) -> Result<&'b [u8], Error>
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
