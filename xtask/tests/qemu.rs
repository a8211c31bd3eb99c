//! Firmware in QEMU against the simulator on this machine.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, ensure};
use embedded_graphics::pixelcolor::Gray4;
use embedded_graphics::prelude::*;
use whitted::animation::AnimatedScene;
use whitted::{Camera, PreparedScene, Real, Renderer};
use whitted_sim::cost::{Model, Work};
use whitted_sim::render;
use whitted_sim::scene_file::{self, SceneFile};
use xtask::firmware::{LM3S6965EVB, MOTION};
use xtask::oled::{self, Button, Oled};
use xtask::qemu::{Arithmetic, Core, Machine};
use xtask::report::Report;
use xtask::soak::soak;
use xtask::{root, scenes, scratch_dir};

#[path = "../../tests/rigs/motion/src/scene.rs"]
mod moving;

const OLED: Size = Size::new(128, 64);
/// QEMU shows each pixel of the OLED as a square of so many.
const ZOOM: usize = 4;

/// The checksum of a scene on this machine.
fn checksum(scene: &Path, size: Size) -> Result<String> {
    let file = scene_file::load(scene)?;
    let mut buffer = Box::new(scene_file::Buffer::new());
    let picture = render::linear(&file.prepare(&mut buffer)?, size);
    Ok(format!("{:08x}", render::checksum(&picture)))
}

/// The simulator's picture of a scene for the OLED.
fn simulated(scene: &Path) -> Result<Picture> {
    let file = scene_file::load(scene)?;
    let mut buffer = Box::new(scene_file::Buffer::new());
    Ok(Picture::of(&file.prepare(&mut buffer)?))
}

/// A picture on the OLED.
#[derive(PartialEq)]
struct Picture {
    levels: Vec<u8>,
    /// Of its linear colors, as the firmware reports it.
    checksum: String,
}

impl Picture {
    /// The library's picture of a scene.
    fn of(scene: &PreparedScene<'_>) -> Self {
        let mut renderer = Renderer::new(scene, OLED);
        let mut line = [Gray4::BLACK; OLED.width as usize];
        let mut levels = Vec::new();
        for y in 0..OLED.height {
            renderer.render_line(y, &mut line);
            levels.extend(line.map(|gray| gray.luma()));
        }
        let picture = render::linear(scene, OLED);
        let checksum = format!("{:08x}", render::checksum(&picture));
        Self { levels, checksum }
    }
}

/// The OLED's picture in a screenshot, as gray levels.
fn shown(ppm: &Path) -> Result<Vec<u8>> {
    let bytes = fs::read(ppm)?;
    let (width, height) = (OLED.width as usize, OLED.height as usize);
    let header = format!("P6\n{} {}\n255\n", ZOOM * width, ZOOM * height);
    let pixels = bytes
        .strip_prefix(header.as_bytes())
        .context("not a screenshot of the OLED")?;
    let rows = pixels.chunks_exact(3 * ZOOM * width);
    ensure!(rows.len() == ZOOM * height, "cut short");
    let mut levels = Vec::new();
    for (y, row) in rows.enumerate() {
        for (x, rgb) in row.chunks_exact(3).enumerate() {
            ensure!(
                rgb == [rgb[0]; 3] && rgb[0] % 17 == 0,
                "no gray of the OLED: {rgb:?}"
            );
            if x % ZOOM == 0 && y % ZOOM == 0 {
                levels.push(rgb[0] / 17);
            } else {
                let whole = levels.get(y / ZOOM * width + x / ZOOM);
                ensure!(
                    y % ZOOM != 0 || whole == Some(&(rgb[0] / 17)),
                    "pixels are squares"
                );
            }
        }
    }
    Ok(levels)
}

fn screenshot(name: &str) -> Result<PathBuf> {
    Ok(scratch_dir()?.join(name).with_extension("ppm"))
}

/// The picture of a scene on the OLED, and the firmware's report, are the
/// simulator's.
fn is_drawn_on_the_oled(scene: &Path) -> Result<()> {
    let elf = LM3S6965EVB.build(Some(scene))?;
    let name = scene.file_stem().unwrap_or_default().display().to_string();
    let shot = screenshot(&name)?;
    let report = oled::draw(&elf, Some(&shot))?;
    report.result()?;
    print!("{name}\n{report}");
    let simulated = simulated(scene)?;
    assert!(
        shown(&shot)? == simulated.levels,
        "{name}: the OLED shows another picture"
    );
    assert_eq!(report.get("checksum")?, simulated.checksum, "{name}");
    Ok(())
}

#[test]
fn the_oled_shows_what_the_simulator_draws() -> Result<()> {
    for scene in ["whitted", "every_surface", "sphereflake"] {
        is_drawn_on_the_oled(&root().join("scenes").join(scene).with_extension("toml"))?;
    }
    Ok(())
}

/// A scene that the firmware shows, and where its camera is.
struct Shown {
    file: SceneFile,
    camera: Camera,
}

impl Shown {
    fn new(name: &str) -> Result<Self> {
        let file = scene_file::load(root().join("scenes").join(name).with_extension("toml"))?;
        let camera = file.settings.camera;
        Ok(Self { file, camera })
    }

    /// Does what a press of an arrow button does.
    fn press(&mut self, button: Button) {
        let [right, up] = match button {
            Button::Up => [0, 15],
            Button::Down => [0, -15],
            Button::Left => [-15, 0],
            Button::Right => [15, 0],
            Button::Select => [0, 0],
        };
        self.camera = self
            .camera
            .orbited(Real::from_num(right), Real::from_num(up));
    }

    /// Whether the OLED shows it, as it is reported.
    fn is_on(&self, oled: &mut Oled, report: &Report) -> Result<()> {
        let mut buffer = Box::new(scene_file::Buffer::new());
        let mut scene = self.file.prepare(&mut buffer)?;
        scene.set_camera(&self.camera)?;
        let expected = Picture::of(&scene);
        assert_eq!(report.get("checksum")?, expected.checksum);
        let shot = screenshot("buttons")?;
        oled.screenshot(&shot)?;
        assert!(
            shown(&shot)? == expected.levels,
            "the OLED shows another picture"
        );
        Ok(())
    }
}

#[test]
fn buttons_move_the_camera_and_switch_scenes() -> Result<()> {
    use Button::{Down, Left, Right, Select, Up};
    let (mut oled, report) = Oled::start(&LM3S6965EVB.build(None)?)?;
    let mut shown = Shown::new("whitted")?;
    shown.is_on(&mut oled, &report)?;
    for button in [Left, Up, Right, Right, Right, Down, Down, Left] {
        let report = oled.press(&[button])?;
        shown.press(button);
        shown.is_on(&mut oled, &report)?;
    }
    // The second interrupts the picture that the first began: there is but one
    // that is completed.
    let report = oled.press(&[Up, Left])?;
    shown.press(Up);
    shown.press(Left);
    shown.is_on(&mut oled, &report)?;

    for name in [
        "four_spheres",
        "every_surface",
        "sphereflake",
        "tinted_diamond",
        "whitted",
    ] {
        let report = oled.press(&[Select])?;
        let mut shown = Shown::new(name)?;
        shown.is_on(&mut oled, &report)?;
        let report = oled.press(&[Right])?;
        shown.press(Right);
        shown.is_on(&mut oled, &report)?;
    }
    Ok(())
}

/// What the project promises at 128x64 on the M3: bytes of RAM beside the
/// display driver's framebuffer and the stack, and of stack.
fn stays_small(scene: &str, most_ram: usize, most_stack: usize) -> Result<()> {
    let scene = root().join("scenes").join(scene).with_extension("toml");
    let report = oled::draw(&LM3S6965EVB.build(Some(&scene))?, None)?;
    let ram = report.number("statics")? - report.number("framebuffer")?;
    assert!(ram <= most_ram as u64, "{ram} bytes of RAM");
    assert!(report.number("stack")? <= most_stack as u64, "{report}");
    assert!(report.number("flash")? <= 64 * 1024, "{report}");
    Ok(())
}

#[test]
fn the_default_scene_stays_small() -> Result<()> {
    stays_small("whitted", 1024, 4 * 1024)
}

/// 3,257,437 spheres.
#[test]
fn a_sphereflake_stays_small() -> Result<()> {
    stays_small("sphereflake", 1024, 5 * 1024)
}

#[test]
fn a_broken_scene_is_told_on_display_and_uart() -> Result<()> {
    let scene = root().join("scenes/whitted.toml");
    let mut bytes = scene_file::compile(&scene)?;
    bytes[40] ^= 1;
    let broken = scratch_dir()?.join("broken.bin");
    fs::write(&broken, bytes)?;

    let shot = screenshot("broken")?;
    let report = oled::draw(&LM3S6965EVB.build(Some(&broken))?, Some(&shot))?;
    assert_eq!(
        report.get("error")?,
        "wrong checksum: the scene is damaged or truncated"
    );
    let lit = shown(&shot)?.iter().filter(|level| **level == 15).count();
    assert!((200..2000).contains(&lit), "{lit} pixels of text");
    Ok(())
}

#[test]
fn products_in_assembly_are_exact() -> Result<()> {
    for core in [Core::M0, Core::M3, Core::M4f, Core::M33] {
        let machine = Machine::of(core);
        let report = machine.run(&machine.products().build(None)?)?;
        report.result()?;
        assert!(report.number("pairs")? > 2_000_000, "{core}: {report}");
    }
    Ok(())
}

#[test]
fn every_core_draws_the_same_pictures() -> Result<()> {
    let large = ["whitted", "sphereflake"].map(|name| {
        let scene = root().join("scenes").join(name).with_extension("toml");
        (scene, Size::new(320, 240))
    });
    let pictures = scenes()?
        .into_iter()
        .map(|scene| (scene, Size::new(80, 60)));
    for (scene, size) in pictures.chain(large) {
        let expected = checksum(&scene, size)?;
        let compiled = Arithmetic::Fixed.compile(&scene)?;
        let size = format!("{}x{}", size.width, size.height);
        for core in Core::ALL {
            let machine = Machine::of(core);
            let elf = machine.firmware(Arithmetic::Fixed).build(None)?;
            let report = machine.draw(&elf, &compiled, &size)?;
            report.result()?;
            assert_eq!(
                report.get("checksum")?,
                expected,
                "{} on {core:?}",
                scene.display()
            );
        }
    }
    Ok(())
}

/// Key frames from statics, evaluated on the core: orbits by floats in software
/// and in hardware.
#[test]
fn every_core_moves_alike() -> Result<()> {
    let [width, height] = moving::SIZE;
    let mut stage = Box::new(AnimatedScene::<5, 1>::new());
    let mut buffer = Box::new(scene_file::Buffer::new());
    let mut expected = Vec::new();
    for time in moving::TIMES {
        let frame = stage.frame(&moving::SCENE, &moving::ANIMATION, time)?;
        let picture = render::linear(&buffer.prepare(&frame)?, Size::new(width, height));
        expected.push(format!("{:08x}", render::checksum(&picture)));
    }
    let cores = [Core::M0, Core::M3, Core::M4f, Core::M33];
    for (core, firmware) in cores.into_iter().zip(MOTION) {
        let report = Machine::of(core).run(&firmware.build(None)?)?;
        report.result()?;
        println!("{core:?}\n{report}");
        for (frame, expected) in expected.iter().enumerate() {
            let key = format!("checksum {frame}");
            assert_eq!(report.get(&key)?, expected, "frame {frame} on {core:?}");
        }
    }
    Ok(())
}

/// The beginning of what `cargo xtask prove soak` watches for longer.
#[test]
fn frame_after_frame_is_drawn_as_here() -> Result<()> {
    for core in [Core::M0, Core::M3] {
        soak(core, 100)?;
    }
    Ok(())
}

/// How far a prediction may be from what is counted, as a share of it.
const TOLERANCE: f64 = 0.1;

#[test]
fn the_cost_model_predicts_what_a_frame_takes() -> Result<()> {
    let model = Model::committed().map_err(anyhow::Error::msg)?;
    // Sizes that it is not fitted to.
    for (name, size) in [
        ("four_spheres", Size::new(64, 48)),
        ("sphereflake", Size::new(32, 24)),
    ] {
        let scene = root().join("scenes").join(name).with_extension("toml");
        let file = scene_file::load(&scene)?;
        let mut buffer = Box::new(scene_file::Buffer::new());
        let work = Work::of(&file.prepare(&mut buffer)?, size);
        let compiled = Arithmetic::Fixed.compile(&scene)?;
        for core in [Core::M0, Core::M3] {
            let machine = Machine::of(core);
            let elf = machine.firmware(Arithmetic::Fixed).build(None)?;
            let size = format!("{}x{}", size.width, size.height);
            let counted = machine
                .draw(&elf, &compiled, &size)?
                .number("instructions")?;
            let prices = model.core(&core.to_string());
            let predicted = prices.context("the core is priced")?.instructions(&work);
            let error = predicted / counted as f64 - 1.0;
            println!("{name} {size} on {core}: {:+.1} %", 100.0 * error);
            assert!(
                error.abs() < TOLERANCE,
                "{name} on {core}: {predicted:.0} predicted, {counted} counted; `cargo xtask fit`"
            );
        }
    }
    Ok(())
}
