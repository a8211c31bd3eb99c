//! `DirtyLines`: frames of a moving scene, of which only changed segments are sent
//! to the display.

use embedded_graphics::Pixel;
use embedded_graphics::pixelcolor::{BinaryColor, Gray4, Rgb565, Rgb888};
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use fastrand::Rng;
use whitted::render::DirtyLines;
use whitted::{
    Camera, Color, Light, Material, MaterialId, Object, Real, Renderer, Scene, SceneBuffer,
    Texture, Vec3, color, real, vec3,
};

/// Picture size; segments are 32 pixels wide, so the last one of each line is partial.
const SIZE: Size = Size::new(150, 60);
const PIXELS: u32 = SIZE.width * SIZE.height;
const FRAMES: i32 = 12;

/// Renders a frame of a sphere that moves along a floor.
fn frame<C: whitted::render::DisplayColor + PixelColor>(number: i32, black: C) -> Vec<Vec<C>> {
    let x = Real::from_num(number) / 8 - Real::ONE;
    let objects = [
        Object::sphere(
            Vec3::new(x, Real::ONE, Real::ZERO),
            Real::ONE,
            MaterialId(1),
        ),
        Object::floor(Real::ZERO, Texture::Uniform(MaterialId(0))),
    ];
    let material = |kd| Material {
        kd,
        ..Material::BLACK
    };
    let scene = Scene {
        lights: &[Light::point(vec3!(-6, 11, 7), Color::gray(Real::ONE))],
        materials: &[
            material(color!(0.1, 0.5, 0.2)),
            material(color!(0.8, 0.6, 0.5)),
        ],
        objects: &objects,
        ..Scene::new(Camera::new(vec3!(0, 3, 9), vec3!(0, 1, 0), real!(33)))
    };
    let mut buffer = SceneBuffer::<2, 1, 2>::new();
    let scene = buffer.prepare(&scene).unwrap();
    let mut renderer = Renderer::new(&scene, SIZE);
    let mut lines = vec![vec![black; SIZE.width as usize]; SIZE.height as usize];
    for (y, line) in (0..).zip(&mut lines) {
        renderer.render_line(y, line);
    }
    lines
}

/// Display that can fail in the middle of a call, after 20 pixels.
struct Screen<C> {
    shown: Vec<Vec<C>>,
    calls: Vec<Rectangle>,
    /// Returns true if the current call fails.
    fails: Box<dyn FnMut() -> bool>,
}

#[derive(Debug, PartialEq)]
struct Unplugged;

impl<C: PixelColor> Screen<C> {
    fn new(color: C, fails: impl FnMut() -> bool + 'static) -> Self {
        Self {
            shown: vec![vec![color; SIZE.width as usize]; SIZE.height as usize],
            calls: Vec::new(),
            fails: Box::new(fails),
        }
    }
}

impl<C> OriginDimensions for Screen<C> {
    fn size(&self) -> Size {
        SIZE
    }
}

impl<C: PixelColor> DrawTarget for Screen<C> {
    type Color = C;
    type Error = Unplugged;

    fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, _: I) -> Result<(), Unplugged> {
        panic!("DirtyLines drew single pixels")
    }

    fn fill_contiguous<I>(&mut self, area: &Rectangle, colors: I) -> Result<(), Unplugged>
    where
        I: IntoIterator<Item = C>,
    {
        let fails = (self.fails)();
        let limit = if fails { 20 } else { usize::MAX };
        for (point, color) in area.points().zip(colors).take(limit) {
            self.shown[point.y as usize][point.x as usize] = color;
        }
        if fails {
            return Err(Unplugged);
        }
        self.calls.push(*area);
        Ok(())
    }
}

/// Sends all frames, repeating lines that fail, and checks the display after each
/// frame. Returns the number of pixels sent per frame.
fn play<C>(screen: &mut Screen<C>, hashes: &mut [u32]) -> Vec<u32>
where
    C: whitted::render::DisplayColor + PixelColor + IntoStorage<Storage: Into<u32>>,
{
    let mut changes = DirtyLines::new(SIZE.width, hashes);
    let mut sent = Vec::new();
    for number in 0..FRAMES {
        let lines = frame(number, screen.shown[0][0]);
        let mut count = 0;
        for (y, line) in (0..).zip(&lines) {
            count += loop {
                if let Ok(count) = changes.send_line(y, line, screen) {
                    break count;
                }
            };
        }
        assert!(screen.shown == lines, "frame {number}");
        sent.push(count);
    }
    sent
}

#[test]
fn sends_less_than_half_of_each_frame() {
    let mut screen = Screen::new(Rgb565::MAGENTA, || false);
    let sent = play(&mut screen, &mut [0; DirtyLines::hashes(SIZE)]);
    println!("{sent:?} of {PIXELS}");
    assert_eq!(sent[0], PIXELS);
    // The first frame is sent completely; later ones send the sphere and its shadow.
    assert!(
        sent[1..]
            .iter()
            .all(|count| (500..PIXELS / 2).contains(count))
    );
    let pixels: u32 = screen.calls.iter().map(|area| area.size.width).sum();
    assert_eq!(pixels, sent.iter().sum::<u32>());
}

#[test]
fn accepts_colors_of_every_depth() {
    let mut hashes = [0; DirtyLines::hashes(SIZE)];
    for sent in [
        play(&mut Screen::new(BinaryColor::On, || false), &mut hashes),
        play(&mut Screen::new(Gray4::WHITE, || false), &mut hashes),
        play(&mut Screen::new(Rgb888::MAGENTA, || false), &mut hashes),
    ] {
        assert_eq!(sent[0], PIXELS);
        assert!(
            sent[1..]
                .iter()
                .all(|count| (100..PIXELS / 2).contains(count))
        );
    }
}

#[test]
fn resends_failed_lines() {
    // Every call fails once.
    let mut fails = false;
    let mut screen = Screen::new(Rgb565::MAGENTA, move || {
        fails = !fails;
        fails
    });
    play(&mut screen, &mut [0; DirtyLines::hashes(SIZE)]);
    for once_in in [2, 9, 60] {
        let mut rng = Rng::with_seed(once_in);
        let mut screen = Screen::new(Rgb565::MAGENTA, move || rng.u64(0..once_in) == 0);
        play(&mut screen, &mut [0; DirtyLines::hashes(SIZE)]);
    }
}

/// A frame can be abandoned after a failure; the next frame repairs the display.
#[test]
fn next_frame_repairs_abandoned_frame() {
    let mut rng = Rng::with_seed(1);
    let mut hashes = [0; DirtyLines::hashes(SIZE)];
    let mut screen = Screen::new(Rgb565::MAGENTA, move || rng.u8(0..30) == 0);
    let mut changes = DirtyLines::new(SIZE.width, &mut hashes);
    for number in 0..FRAMES {
        let lines = frame(number, Rgb565::BLACK);
        let mut lines = (0..).zip(&lines);
        // Sends lines until one fails.
        while let Some((y, line)) = lines.next()
            && changes.send_line(y, line, &mut screen).is_ok()
        {}
    }
    screen.fails = Box::new(|| false);
    let lines = frame(0, Rgb565::BLACK);
    for (y, line) in (0..).zip(&lines) {
        changes.send_line(y, line, &mut screen).unwrap();
    }
    assert!(screen.shown == lines);
}

#[test]
fn merges_adjacent_segments() {
    let mut screen = Screen::new(Gray4::BLACK, || false);
    let mut hashes = [7; DirtyLines::hashes(SIZE)];
    let mut changes = DirtyLines::new(SIZE.width, &mut hashes);
    let mut line = [Gray4::BLACK; SIZE.width as usize];
    let mut send = |line: &[Gray4]| {
        screen.calls.clear();
        let sent = changes.send_line(3, line, &mut screen).unwrap();
        let span = |area: &Rectangle| {
            assert_eq!((area.top_left.y, area.size.height), (3, 1));
            (area.top_left.x, area.size.width)
        };
        let spans: Vec<_> = screen.calls.iter().map(span).collect();
        assert_eq!(sent, spans.iter().map(|(_, width)| width).sum::<u32>());
        spans
    };
    assert_eq!(send(&line), [(0, 150)]);
    assert_eq!(send(&line), []);
    (line[0], line[31]) = (Gray4::WHITE, Gray4::WHITE);
    (line[32], line[149]) = (Gray4::WHITE, Gray4::WHITE);
    assert_eq!(send(&line), [(0, 64), (128, 22)]);
    // Swapping two colors must change the hash of their segment.
    line.swap(32, 33);
    assert_eq!(send(&line), [(32, 32)]);
    // Slices shorter and longer than the line.
    line[1] = Gray4::WHITE;
    assert_eq!(send(&line[..64]), [(0, 32)]);
    line[100] = Gray4::WHITE;
    let longer = [line.as_slice(), &[Gray4::WHITE; 20]].concat();
    assert_eq!(send(&longer), [(96, 32)]);
    assert_eq!(send(&[]), []);
}

#[test]
fn sends_everything_after_forget_and_without_hashes() {
    let mut screen = Screen::new(Gray4::BLACK, || false);
    let line = [Gray4::BLACK; SIZE.width as usize];
    // Memory for the hashes of two lines and two segments of a third.
    let mut hashes = [0; 12];
    let mut changes = DirtyLines::new(SIZE.width, &mut hashes);
    let mut broken = Screen::new(Gray4::BLACK, || true);
    assert_eq!(changes.send_line(2, &line, &mut broken), Err(Unplugged));
    for y in [0, 1, 2, 59, u32::MAX] {
        assert_eq!(changes.send_line(y, &line, &mut NullDisplay), Ok(150));
    }
    let mut again = |y| changes.send_line(y, &line, &mut screen);
    assert_eq!(
        [again(0), again(1), again(2), again(59)],
        [Ok(0), Ok(0), Ok(86), Ok(150)]
    );
    changes.forget();
    assert_eq!(changes.send_line(1, &line, &mut screen), Ok(150));
}

/// Display that accepts every pixel and records none.
struct NullDisplay;

impl OriginDimensions for NullDisplay {
    fn size(&self) -> Size {
        SIZE
    }
}

impl DrawTarget for NullDisplay {
    type Color = Gray4;
    type Error = Unplugged;

    fn draw_iter<I: IntoIterator<Item = Pixel<Gray4>>>(&mut self, _: I) -> Result<(), Unplugged> {
        Ok(())
    }
}
