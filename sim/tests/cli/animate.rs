//! `sim animate`.

use std::fs::{self, File};
#[cfg(target_os = "linux")]
use std::{process::Stdio, thread::sleep, time::Duration};

use whitted_sim::png16;

use crate::directory::{Directory, Outcome};
use crate::frames::{apng_frames, gif_frames};

/// GIF, APNG and numbered PNGs have equal frames. With 16 grays, the palette of the GIF is exact.
#[test]
fn all_formats_have_equal_frames() -> Outcome {
    let here = Directory::new("animate")?;
    let scene = [
        "animate",
        "bouncing_ball",
        "--size",
        "40x30",
        "--frames",
        "4",
    ];
    let gray = [&scene[..], &["--format", "gray4", "-o"]].concat();
    let output = here.ok(&[&gray[..], &["out"]].concat())?;
    assert_eq!(output, format!("wrote {}\n", here.0.join("out").display()));
    here.ok(&[&gray[..], &["ball.gif"]].concat())?;
    here.ok(&[&gray[..], &["ball.apng"]].concat())?;
    let mut frames = Vec::new();
    for index in 0..4 {
        let picture = png16::read(here.0.join(format!("out/frame-000{index}.png")))?;
        let samples = picture.pixels.iter().flat_map(|c| [c.r, c.g, c.b]);
        frames.push(
            samples
                .map(|sample| (sample / 257) as u8)
                .collect::<Vec<_>>(),
        );
    }
    frames.windows(2).for_each(|two| assert!(two[0] != two[1]));
    let of_gif = gif_frames(&here.0.join("ball.gif"))?;
    let of_apng = apng_frames(&here.0.join("ball.apng"))?;
    assert!(of_gif.0 == frames && of_apng.0 == frames);
    // Four frames in two seconds.
    assert_eq!((of_gif.1, of_apng.1), (vec![50; 4], vec![500; 4]));

    // The first frame equals the scene without animation.
    let render = [
        "render",
        "bouncing_ball",
        "--size",
        "40x30",
        "--format",
        "gray4",
    ];
    here.ok(&render)?;
    let output = here.ok(&["compare", "bouncing_ball.png", "out/frame-0000.png"])?;
    assert!(output.ends_with("the pictures are equal\n"), "{output}");
    Ok(())
}

/// A ball that moves a little in front of a static background.
const BALL: &str = r#"
[camera]
eye = [0, 0, 8]
look_at = [0, 0, 0]
fovy_deg = 33
[materials.white]
le = [1, 1, 1]
[[objects]]
type = "sphere"
name = "ball"
center = [0, 0, 0]
radius = 0.5
material = "white"
[animation]
duration = 1
[[animation.tracks]]
target = "objects.ball.center"
keys = [[0, [0, 0, 0]], [1, [1, -0.5, 0]]]
"#;

#[test]
fn writes_only_the_changed_area_of_a_frame() -> Outcome {
    let here = Directory::new("change")?;
    fs::write(here.0.join("ball.toml"), BALL)?;
    let scene = [
        "animate",
        "ball.toml",
        "--size",
        "40x30",
        "--frames",
        "3",
        "-o",
    ];
    here.ok(&[&scene[..], &["ball.gif"]].concat())?;
    here.ok(&[&scene[..], &["ball.apng"]].concat())?;
    here.ok(&[&scene[..], &["out"]].concat())?;
    let (of_gif, _) = gif_frames(&here.0.join("ball.gif"))?;
    let (of_apng, _) = apng_frames(&here.0.join("ball.apng"))?;
    for (index, (of_gif, of_apng)) in of_gif.iter().zip(&of_apng).enumerate() {
        let picture = png16::read(here.0.join(format!("out/frame-000{index}.png")))?;
        let samples = picture.pixels.iter().flat_map(|c| [c.r, c.g, c.b]);
        let samples: Vec<_> = samples.map(|sample| (sample / 257) as u8).collect();
        assert!(*of_gif == samples && *of_apng == samples, "frame {index}");
    }
    let mut reader = gif::DecodeOptions::new().read_info(File::open(here.0.join("ball.gif"))?)?;
    let mut sizes = Vec::new();
    while let Some(frame) = reader.next_frame_info()? {
        sizes.push((frame.width, frame.height));
    }
    assert_eq!(sizes[0], (40, 30));
    assert!(
        sizes[1..]
            .iter()
            .all(|(width, height)| *width < 16 && *height < 12),
        "{sizes:?}"
    );
    Ok(())
}

#[test]
fn gif_palette_approximates_many_colors() -> Outcome {
    let here = Directory::new("colors")?;
    let scene = [
        "animate",
        "bouncing_ball",
        "--size",
        "64x48",
        "--frames",
        "3",
        "-o",
    ];
    here.ok(&[&scene[..], &["ball.gif"]].concat())?;
    here.ok(&[&scene[..], &["ball.png"]].concat())?;
    let (few, _) = gif_frames(&here.0.join("ball.gif"))?;
    let (all, _) = apng_frames(&here.0.join("ball.png"))?;
    for (few, all) in few.iter().zip(&all) {
        let off = few.iter().zip(all).map(|(a, b)| u32::from(a.abs_diff(*b)));
        let mean = f64::from(off.sum::<u32>()) / few.len() as f64;
        assert!(mean < 3.0, "off by {mean} of 255");
    }
    Ok(())
}

#[test]
fn scene_without_animation_makes_one_orbit() -> Outcome {
    let here = Directory::new("orbit")?;
    let output = here.ok(&[
        "animate", "whitted", "--size", "16x12", "--frames", "4", "-o", "w.gif",
    ])?;
    let note = "the scene has no [animation]: the camera makes one orbit\n";
    assert!(output.starts_with(note), "{output}");
    let (frames, delays) = gif_frames(&here.0.join("w.gif"))?;
    assert_eq!((frames.len(), delays), (4, vec![100; 4]));
    Ok(())
}

#[test]
fn errors_name_the_keyframe() -> Outcome {
    let here = Directory::new("vanishing")?;
    let scene = r#"
[camera]
eye = [0, 1, 8]
look_at = [0, 1, 0]
fovy_deg = 33
[animation]
duration = 1
loop = false
[[animation.tracks]]
target = "camera.eye"
keys = [[0, [0, 1, 8]],
  [1, [0, 1, 0]]]
"#;
    fs::write(here.0.join("vanishing.toml"), scene)?;
    let args = [
        "animate",
        "vanishing.toml",
        "--size",
        "2x2",
        "--frames",
        "2",
        "-o",
        "x.gif",
    ];
    let output = here.error(&args)?;
    let expected = "error: vanishing.toml:12: animation.tracks[0].keys[1]: look_at must differ";
    assert!(output.starts_with(expected), "{output}");
    Ok(())
}

/// A long GIF takes little more memory than a short one, because its frames are not kept.
#[cfg(target_os = "linux")]
#[test]
fn long_animations_take_little_memory() -> Outcome {
    let here = Directory::empty("memory")?;
    let peak = |frames: &str| -> Result<usize, Box<dyn std::error::Error>> {
        let size = ["--size", "120x90", "--fps", "50", "--frames", frames];
        let args = [&["animate", "bouncing_ball", "-o", "x.gif"][..], &size].concat();
        let mut program = here.command(&args).stdout(Stdio::null()).spawn()?;
        let mut peak = 0;
        while program.try_wait()?.is_none() {
            let status = fs::read_to_string(format!("/proc/{}/status", program.id()))?;
            let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
            let kilobytes = line.and_then(|line| line.trim().strip_suffix(" kB"));
            peak = peak.max(kilobytes.map_or(Ok(0), str::parse)?);
            sleep(Duration::from_millis(5));
        }
        assert!(program.wait()?.success());
        Ok(peak)
    };
    let [short, long] = [peak("10")?, peak("200")?];
    // The other 190 frames have 6 MB.
    assert!(long < short + 3000, "{short} kB and {long} kB");
    Ok(())
}

/// Frame rates up to 50 per second keep the duration, and have no delay below 2/100 s.
#[test]
fn gif_delays_keep_the_duration() -> Outcome {
    let here = Directory::new("rates")?;
    for fps in ["3", "24", "49", "50"] {
        let args = ["--size", "4x3", "--fps", fps, "-o", "x.gif"];
        here.ok(&[&["animate", "bouncing_ball"][..], &args].concat())?;
        let (_, delays) = gif_frames(&here.0.join("x.gif"))?;
        assert_eq!(delays.iter().sum::<u16>(), 200, "{fps}");
        assert!(delays.iter().all(|delay| *delay >= 2), "{delays:?}");
    }
    // A delay of 100 s does not fit in 16 bits of milliseconds.
    let slow = BALL
        .replace("duration = 1", "duration = 200")
        .replace("[1, [", "[200, [");
    fs::write(here.0.join("slow.toml"), slow)?;
    let args = [
        "animate",
        "slow.toml",
        "--size",
        "4x3",
        "--frames",
        "2",
        "-o",
    ];
    here.ok(&[&args[..], &["x.gif"]].concat())?;
    assert_eq!(gif_frames(&here.0.join("x.gif"))?.1, [10_000; 2]);
    here.ok(&[&args[..], &["x.apng"]].concat())?;
    assert_eq!(apng_frames(&here.0.join("x.apng"))?.1, [10_000; 2]);
    let slower = BALL.replace("duration = 1", "duration = 2000");
    fs::write(here.0.join("slow.toml"), slower)?;
    let message = here.error(&[&args[..], &["x.gif"]].concat())?;
    assert!(message.starts_with("error: x.gif: a frame of a GIF lasts at most 655.35 s\n"));
    Ok(())
}

#[test]
fn displays_and_antialiasing_apply_to_animations_and_galleries() -> Outcome {
    let here = Directory::empty("looks")?;
    let looks: [&[&str]; 4] = [
        &["--size", "40x30"],
        &["--size", "40x30", "--antialias", "4"],
        &["--size", "40x30", "--transfer", "linear"],
        &["--display", "ssd1306"],
    ];
    let mut pictures = Vec::new();
    for look in looks {
        here.ok(&[&["render", "bouncing_ball", "-o", "x.png"], look].concat())?;
        let picture = png16::read(here.0.join("x.png"))?;
        let animate = ["animate", "bouncing_ball", "--frames", "1", "-o", "out/"];
        here.ok(&[&animate[..], look].concat())?;
        assert!(png16::read(here.0.join("out/frame-0000.png"))? == picture);
        here.ok(&[&["gallery", "bouncing_ball", "-o", "all"], look].concat())?;
        assert!(png16::read(here.0.join("all/bouncing_ball.png"))? == picture);
        assert!(!pictures.contains(&picture), "{look:?}");
        pictures.push(picture);
    }
    Ok(())
}
