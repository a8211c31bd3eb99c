use embedded_graphics_core::geometry::Size;
use whitted::observer::{Observer, RayKind};
use whitted::{Color, PreparedScene, Radiance, Renderer, SceneBuffer};

/// So small that the worst of scenes is drawn soon.
const SIZE: Size = Size::new(4, 3);

/// What docs/trust.md says that a pixel takes at most: rays, and shadow rays of
/// each light.
const RAYS: usize = 4096;

/// Counts the rays of a picture.
#[derive(Default)]
struct Rays {
    traced: usize,
    shadow: usize,
}

impl Observer for Rays {
    fn ray(&mut self, kind: RayKind) {
        match kind {
            RayKind::Shadow => self.shadow += 1,
            _ => self.traced += 1,
        }
    }
}

/// A tiny picture, drawn with no more rays than a pixel may take.
pub(crate) fn draw(scene: &PreparedScene<'_>) -> Vec<Color<Radiance>> {
    let lights = scene.counts().lights;
    let mut renderer = Renderer::with_observer(scene, SIZE, Rays::default());
    let mut picture = Vec::new();
    for y in 0..SIZE.height {
        for x in 0..SIZE.width {
            picture.push(renderer.pixel(x, y));
            let most = RAYS * picture.len();
            let Rays { traced, shadow } = *renderer.observer();
            assert!(
                traced <= most && shadow <= most * lights,
                "{traced} {shadow}"
            );
        }
    }
    // Lines are drawn by another way, to the same colors.
    let lines = (0..SIZE.height).flat_map(|y| renderer.line(y).collect::<Vec<_>>());
    let lines: Vec<_> = lines.collect();
    assert!(lines == picture, "lines and pixels differ");
    picture
}

/// The same of a scene that was prepared; its compiled form is accepted and
/// drawn alike.
pub(crate) fn draw_as_compiled(scene: &PreparedScene<'_>) {
    let mut bytes = vec![0; scene.encoded_len()];
    assert_eq!(scene.encode(&mut bytes), Some(bytes.len()));
    let mut buffer = Box::new(SceneBuffer::<256, 16, 256>::new());
    match buffer.decode(&bytes) {
        Ok(decoded) => assert!(
            draw(&decoded) == draw(scene),
            "compiled, it looks otherwise"
        ),
        Err(error) => panic!("{error}, of a scene that was prepared"),
    }
}
