use embedded_graphics_core::geometry::Size;
use whitted::observer::{Observer, RayKind};
use whitted::{Color, PreparedScene, Radiance, Renderer, SceneBuffer};

/// Small picture, so that the slowest scene is drawn quickly.
const SIZE: Size = Size::new(4, 3);

/// Upper limit of rays per pixel, and of shadow rays per pixel and light (docs/trust.md).
const MAX_RAYS: usize = 4096;

/// Counts the rays of a picture.
#[derive(Default)]
struct RayCounter {
    traced: usize,
    shadow: usize,
}

impl Observer for RayCounter {
    fn ray(&mut self, kind: RayKind) {
        match kind {
            RayKind::Shadow => self.shadow += 1,
            _ => self.traced += 1,
        }
    }
}

/// Draws a small picture pixel by pixel and line by line.
///
/// Checks the number of rays per pixel, and that drawing by pixel and drawing by line give
/// equal colors.
pub(crate) fn draw(scene: &PreparedScene<'_>) -> Vec<Color<Radiance>> {
    let lights = scene.counts().lights;
    let mut renderer = Renderer::with_observer(scene, SIZE, RayCounter::default());
    let mut picture = Vec::new();
    for y in 0..SIZE.height {
        for x in 0..SIZE.width {
            picture.push(renderer.pixel(x, y));
            let limit = MAX_RAYS * picture.len();
            let RayCounter { traced, shadow } = *renderer.observer();
            assert!(
                traced <= limit && shadow <= limit * lights,
                "{traced} rays and {shadow} shadow rays exceed the limit of {limit}"
            );
        }
    }
    let lines = (0..SIZE.height).flat_map(|y| renderer.line(y).collect::<Vec<_>>());
    let lines: Vec<_> = lines.collect();
    assert!(lines == picture, "lines and pixels have different colors");
    picture
}

/// Draws a prepared scene and its compiled form, and checks that both have equal pixels.
pub(crate) fn draw_as_compiled(scene: &PreparedScene<'_>) {
    let mut bytes = vec![0; scene.encoded_len()];
    assert_eq!(scene.encode(&mut bytes), Some(bytes.len()));
    let mut buffer = Box::new(SceneBuffer::<256, 16, 256>::new());
    match buffer.decode(&bytes) {
        Ok(decoded) => assert!(
            draw(&decoded) == draw(scene),
            "the compiled scene has different pixels"
        ),
        Err(error) => panic!("the compiled form of a valid scene is rejected: {error}"),
    }
}
