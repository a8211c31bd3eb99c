//! Calls every function that builds, prepares, decodes or changes a scene.

use core::hint::black_box;

use whitted::codec::Crc32;
use whitted::scene::{SceneBuilder, SceneCounts};
use whitted::{
    Camera, Color, Light, Material, MaterialId, Object, PreparedScene, Real, Scene, SceneBuffer,
    Texture, Vec3,
};

use crate::{displays, text};

pub(crate) type Buffer = SceneBuffer<8, 2, 4>;

/// Scene that is passed by reference through `black_box`, which hides its content from the
/// compiler: all shapes, counts and numbers.
pub(crate) static SCENE: Scene = Scene::new(Camera::new(ORIGIN, ORIGIN, Real::ZERO));
const ORIGIN: Vec3<Real> = Vec3::new(Real::ZERO, Real::ZERO, Real::ZERO);

pub(crate) fn prepare() {
    let mut buffer = Buffer::default();
    match buffer.prepare(black_box(&SCENE)) {
        Ok(scene) => draw(scene),
        Err(error) => text::print(&error),
    }
}

pub(crate) fn decode() {
    let bytes: &[u8] = black_box(&[]);
    black_box(SceneCounts::of_all(&[bytes]));
    let counts = SceneCounts::of_compiled(bytes).objects(1).lights(1);
    black_box(counts.materials(1).max(SceneCounts::EMPTY));
    let mut buffer = Buffer::new();
    match buffer.decode(bytes) {
        Ok(scene) => draw(scene),
        Err(error) => text::print(&error),
    }
}

fn draw(mut scene: PreparedScene<'_>) {
    let camera = scene.camera().orbited(number(), number());
    if let Err(error) = scene.set_camera(&camera) {
        text::print(&error);
    }
    black_box(scene.set_max_depth(black_box(0)).is_ok());
    black_box(scene.set_min_weight(black_box(Real::ZERO)).is_ok());
    black_box((scene.max_depth(), scene.transfer()));
    black_box((scene.counts(), scene.encoded_len()));
    let mut bytes = [0; 64];
    let out: &mut [u8] = black_box(&mut bytes);
    black_box(scene.encode(out));
    displays::draw_on_all(black_box(&scene));
}

/// Builds a scene with [`SceneBuilder`] and computes a checksum.
pub(crate) fn build() {
    let point = || Vec3::new(number(), number(), number());
    let color = || Color::new(number(), number(), number()).map(black_box);
    let mut builder = SceneBuilder::<2, 1, 1>::new(Camera::new(point(), point(), number()));
    let material = MaterialId(black_box(0));
    let objects = [
        Object::sphere(point(), number(), material),
        Object::sphereflake(point(), number(), black_box(0), material),
        Object::floor(number(), Texture::Uniform(material)),
    ];
    for object in objects {
        black_box(builder.object(object).is_ok());
    }
    let level = || black_box(0);
    let srgb = Color::srgb(level(), level(), level());
    for color in [color(), Color::gray(number()), srgb] {
        black_box(builder.light(Light::point(point(), color)).is_ok());
    }
    black_box(builder.material(*black_box(&Material::default())).is_ok());
    black_box((builder.objects_mut().len(), builder.lights_mut().len()));
    black_box(builder.scene());

    let mut crc = Crc32::new();
    crc.update(black_box(&[]));
    crc.update_pixel(*black_box(&Color::default()));
    black_box(crc.finish());
}

/// Returns a number that the compiler does not know.
pub(crate) fn number() -> Real {
    black_box(Real::ZERO)
}
