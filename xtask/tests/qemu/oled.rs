//! The LM3S6965 board: pictures on its OLED, buttons, memory.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU32, Ordering};

use anyhow::{Context, Result, ensure};
use embedded_graphics::pixelcolor::Gray4;
use embedded_graphics::prelude::*;
use whitted::{Camera, PreparedScene, Real, Renderer};
use whitted_sim::render;
use whitted_sim::scene_file::{self, SceneFile};
use xtask::firmware::LM3S6965EVB;
use xtask::oled::{self, Button, Oled};
use xtask::report::Report;
use xtask::{gallery_scene, host, scene, scratch_dir};

const SIZE: Size = Size::new(128, 64);

/// Width and height of an OLED pixel in QEMU's window.
const ZOOM: usize = 4;

/// Draws on the host. Returns gray levels, 0 to 15, and the checksum of the linear colors.
fn draw_on_host(scene: &PreparedScene<'_>) -> (Vec<u8>, String) {
    let mut renderer = Renderer::new(scene, SIZE);
    let mut line = [Gray4::BLACK; SIZE.width as usize];
    let mut levels = Vec::new();
    for y in 0..SIZE.height {
        renderer.render_line(y, &mut line);
        levels.extend(line.map(|gray| gray.luma()));
    }
    let checksum = render::checksum(&render::linear(scene, SIZE));
    (levels, format!("{checksum:08x}"))
}

/// Returns the gray levels of the OLED in a screenshot.
fn read_screenshot(ppm: &Path) -> Result<Vec<u8>> {
    let bytes = fs::read(ppm)?;
    let (width, height) = (SIZE.width as usize, SIZE.height as usize);
    let header = format!("P6\n{} {}\n255\n", ZOOM * width, ZOOM * height);
    let pixels = bytes
        .strip_prefix(header.as_bytes())
        .context("not a screenshot of the OLED")?;
    ensure!(
        pixels.len() == 3 * ZOOM * width * ZOOM * height,
        "cut short"
    );
    let mut levels = Vec::new();
    for (y, row) in pixels.chunks_exact(3 * ZOOM * width).enumerate() {
        for (x, rgb) in row.chunks_exact(3).enumerate() {
            ensure!(
                rgb == [rgb[0]; 3] && rgb[0] % 17 == 0,
                "{rgb:?} is not one of 16 gray levels"
            );
            let level = rgb[0] / 17;
            if x % ZOOM == 0 && y % ZOOM == 0 {
                levels.push(level);
            }
            let first = levels.get(y / ZOOM * width + x / ZOOM);
            ensure!(first == Some(&level), "a pixel has several colors");
        }
    }
    Ok(levels)
}

fn screenshot(name: &str) -> Result<PathBuf> {
    Ok(scratch_dir()?.join(name).with_extension("ppm"))
}

/// A scene on the board, and the camera after some presses of buttons.
struct Expected {
    file: SceneFile,
    camera: Camera,
}

impl Expected {
    fn new(scene: &Path) -> Result<Self> {
        let file = scene_file::load(scene)?;
        let camera = file.settings.camera;
        Ok(Self { file, camera })
    }

    /// Moves the camera as the firmware does.
    fn press(&mut self, button: Button) {
        let [right, up] = match button {
            Button::Up => [0, 15],
            Button::Down => [0, -15],
            Button::Left => [-15, 0],
            Button::Right => [15, 0],
            Button::Select => [0, 0],
        };
        let [right, up] = [right, up].map(Real::from_num::<i32>);
        self.camera = self.camera.orbited(right, up);
    }

    /// Compares the report and the OLED with the host's picture.
    fn compare(&self, oled: &mut Oled, report: &Report) -> Result<()> {
        let mut buffer = Box::new(scene_file::Buffer::new());
        let mut scene = self.file.prepare(&mut buffer)?;
        scene.set_camera(&self.camera)?;
        let (levels, checksum) = draw_on_host(&scene);
        assert_eq!(report.result()?.get("checksum")?, checksum);
        // Tests run in parallel and need files of their own.
        static COUNT: AtomicU32 = AtomicU32::new(0);
        let count = COUNT.fetch_add(1, Ordering::Relaxed);
        let shot = screenshot(&format!("oled_{}", count % 16))?;
        oled.screenshot(&shot)?;
        assert!(read_screenshot(&shot)? == levels, "the OLED differs");
        Ok(())
    }
}

/// Draws a scene in flash. Flash, RAM without framebuffer and stack, and stack stay below the
/// documented limits.
#[test]
fn shows_the_pictures_of_the_host() -> Result<()> {
    for (name, stack) in [("whitted", 4 * 1024), ("sphereflake", 5 * 1024)] {
        let scene = scene(name);
        let (mut oled, report) = Oled::start(&LM3S6965EVB.build(Some(&scene))?)?;
        print!("{name}\n{report}");
        Expected::new(&scene)?.compare(&mut oled, &report)?;
        let ram = report.number("statics")? - report.number("framebuffer")?;
        assert!(ram <= 1024, "{name}: {ram} bytes of RAM");
        assert!(report.number("stack")? <= stack, "{name}: {report}");
        assert!(report.number("flash")? <= 64 * 1024, "{name}: {report}");
    }
    Ok(())
}

#[test]
fn buttons_move_the_camera_and_select_scenes() -> Result<()> {
    use Button::{Down, Left, Right, Select, Up};
    let (mut oled, report) = Oled::start(&LM3S6965EVB.build(None)?)?;
    let mut expected = Expected::new(&gallery_scene("whitted"))?;
    expected.compare(&mut oled, &report)?;
    for button in [Left, Up, Right, Right, Right, Down, Down, Left] {
        let report = oled.press(&[button])?;
        expected.press(button);
        expected.compare(&mut oled, &report)?;
    }
    // The second button interrupts the picture of the first, so there is one report.
    let report = oled.press(&[Up, Left])?;
    expected.press(Up);
    expected.press(Left);
    expected.compare(&mut oled, &report)?;

    for name in [
        "four_spheres",
        "every_surface",
        "sphereflake",
        "tinted_diamond",
        "whitted",
    ] {
        let report = oled.press(&[Select])?;
        let mut expected = Expected::new(&gallery_scene(name))?;
        expected.compare(&mut oled, &report)?;
        let report = oled.press(&[Right])?;
        expected.press(Right);
        expected.compare(&mut oled, &report)?;
    }
    Ok(())
}

#[test]
fn shows_and_reports_the_error_of_a_damaged_scene() -> Result<()> {
    let mut bytes = scene_file::compile(scene("whitted"))?;
    bytes[40] ^= 1;
    let damaged = scratch_dir()?.join("damaged.bin");
    fs::write(&damaged, &bytes)?;

    let shot = screenshot("damaged")?;
    let report = oled::draw(&LM3S6965EVB.build(Some(&damaged))?, Some(&shot))?;
    assert_eq!(report.get("error")?, host::decode_error(&bytes)?);
    let levels = read_screenshot(&shot)?;
    let white = levels.iter().filter(|level| **level == 15).count();
    assert!((200..2000).contains(&white), "{white} pixels of text");
    Ok(())
}
