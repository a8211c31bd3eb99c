//! Tests `sim view` on an X screen: presses keys and reads the window's pixels.
//!
//! Run with `cargo xtask test window`, or
//! `xvfb-run cargo test --package whitted-sim --features window --test window`.

mod outcome;
mod screen;
mod shot;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};

use outcome::Outcome;
use screen::Screen;
use shot::Shot;

/// Colors of the status text: errors, the title, and other lines.
const ERROR: [u8; 3] = [0xff, 0x6b, 0x5e];
const BRIGHT: [u8; 3] = [0xff; 3];
const PLAIN: [u8; 3] = [0xb8, 0xbe, 0xc8];

const RIGHT: u32 = 0xff53;
const UP: u32 = 0xff52;

/// Running program, killed when dropped.
struct Running(Child);

impl Drop for Running {
    fn drop(&mut self) {
        _ = self.0.kill();
        _ = self.0.wait();
    }
}

/// Directory with the scenes and pictures of the test.
struct Directory(PathBuf);

impl Directory {
    fn new() -> Outcome<Self> {
        let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("window");
        _ = fs::remove_dir_all(&path);
        fs::create_dir_all(&path)?;
        Ok(Self(path))
    }

    fn sim(&self, args: &[&str]) -> Command {
        let mut sim = Command::new(env!("CARGO_BIN_EXE_sim"));
        sim.args(args).current_dir(&self.0).stdout(Stdio::null());
        sim
    }

    /// Returns the picture that `sim render` writes.
    fn rendered(&self, args: &[&str]) -> Outcome<Shot> {
        let status = self
            .sim(&[&["render", "-o", "expected.png"], args].concat())
            .status()?;
        assert!(status.success());
        Shot::read(&self.0.join("expected.png"))
    }

    /// Saves a file by renaming a new one over it, as editors do.
    fn save(&self, name: &str, text: &str) -> Outcome {
        let new = self.0.join("new");
        fs::write(&new, text)?;
        Ok(fs::rename(new, self.0.join(name))?)
    }
}

fn scene(name: &str) -> Outcome<String> {
    let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes");
    Ok(fs::read_to_string(
        scenes.join(name).with_extension("toml"),
    )?)
}

#[test]
fn view_follows_keys_and_files() -> Outcome {
    let here = Directory::new()?;
    let good = scene("whitted")?;
    here.save("one.toml", &good)?;
    here.save("two.toml", &scene("still_life")?)?;

    let view = ["view", "one.toml", "two.toml", "--display", "ssd0323"];
    let mut sim = Running(here.sim(&view).spawn()?);
    let screen = Screen::connect()?;
    let window = screen.window("whitted");
    let on_oled = ["--display", "ssd0323", "--scale", "5"];
    let oled = here.rendered(&[&["one.toml"][..], &on_oled].concat())?;
    window.wait_for("the scene on the OLED", |shot| shot.shows(&oled))?;

    // The saved picture is the one on the screen.
    window.press('s'.into())?;
    window.wait_for("the message that the picture is saved", |shot| {
        shot.says("wrote one-ssd0323.png", PLAIN)
    })?;
    let saved = Shot::read(&here.0.join("one-ssd0323.png"))?;
    assert!(saved == here.rendered(&["one.toml", "--display", "ssd0323"])?);

    // Dithering and transfer function. Two more presses of `g` select sRGB and then the transfer
    // function of the scene, which is sRGB too.
    for (key, option, back) in [
        ('t', ["--dither", "off"], 1),
        ('g', ["--transfer", "linear"], 2),
    ] {
        let other = here.rendered(&[&["one.toml"][..], &on_oled, &option].concat())?;
        assert!(other != oled);
        window.press(key.into())?;
        window.wait_for("the changed output", |shot| shot.shows(&other))?;
        for _ in 0..back {
            window.press(key.into())?;
            window.wait_for("the previous output", |shot| shot.shows(&oled))?;
        }
    }
    let title = |antialiasing| {
        format!(
            "one (1 of 2) on ssd0323 128x64 gray4, dither, the scene's transfer, {antialiasing}, line by line"
        )
    };
    window.press('o'.into())?;
    window.wait_for("the other order", |shot| {
        shot.shows(&oled) && shot.says(&title("no antialiasing"), BRIGHT)
    })?;

    let antialiased = here.rendered(&[&["one.toml", "--antialias", "4"][..], &on_oled].concat())?;
    window.press('a'.into())?;
    window.wait_for("antialiasing with 4 rays", |shot| {
        shot.shows(&antialiased) && shot.says(&title("4 rays at edges"), BRIGHT)
    })?;
    window.press('a'.into())?;
    window.wait_for("antialiasing with 16 rays", |shot| {
        shot.says(&title("16 rays at edges"), BRIGHT)
    })?;
    window.press('a'.into())?;
    window.wait_for("no antialiasing", |shot| shot.shows(&oled))?;

    // Orbit, zoom, and reset of the camera.
    for key in [RIGHT, UP, '='.into()] {
        window.press(key)?;
        window.wait_for("the moved camera", |shot| !shot.shows(&oled))?;
        window.press('r'.into())?;
        window.wait_for("the camera reset", |shot| shot.shows(&oled))?;
    }

    // An invalid file shows an error and keeps the picture.
    here.save("one.toml", &format!("colour = 1\n{good}"))?;
    let error = "one.toml:1: colour: a scene has no such key";
    let shot = window.wait_for("the error", |shot| shot.says(error, ERROR))?;
    assert!(shot.shows(&oled), "the last good picture stays");
    let fixed = good.replace("fovy_deg = 33", "fovy_deg = 50");
    assert_ne!(fixed, good);
    here.save("one.toml", &fixed)?;
    let wider = here.rendered(&[&["one.toml"][..], &on_oled].concat())?;
    assert!(wider != oled);
    window.wait_for("the fixed scene", |shot| {
        shot.shows(&wider) && !shot.says(error, ERROR)
    })?;

    // Another display, and another scene.
    window.press('d'.into())?;
    let tft = here.rendered(&["one.toml", "--display", "st7735", "--scale", "3"])?;
    window.wait_for("the scene on the TFT", |shot| shot.shows(&tft))?;
    window.press('n'.into())?;
    let tft = here.rendered(&["two.toml", "--display", "st7735", "--scale", "3"])?;
    window.wait_for("the other scene", |shot| shot.shows(&tft))?;

    window.press('h'.into())?;
    window.wait_for("help", |shot| shot.says("q, Esc  quit", PLAIN))?;
    window.press('q'.into())?;
    assert!(sim.0.wait()?.success());
    Ok(())
}
