//! `sim render --stats`.

use std::path::Path;

use embedded_graphics_core::geometry::Size;
use whitted_sim::cost::{BOARDS, Work};
use whitted_sim::scene_file;

use crate::directory::{Directory, Outcome};

#[test]
fn stats_end_with_the_checksum() -> Outcome {
    let here = Directory::new("stats")?;
    let size = ["--size", "16x12", "--stats"];
    let display = here.ok(&[&["render", "whitted", "-o", "a.png"][..], &size].concat())?;
    let linear = here.ok(&[&["render", "whitted", "--linear16"][..], &size].concat())?;
    assert!(display.contains("\nrays: 192 camera, "), "{display}");
    assert!(display.contains("\nintersection tests: "), "{display}");
    assert!(display.contains("\ntime: "), "{display}");
    for board in ["Cortex-M0+ at 133 MHz", "Cortex-M7 at 480 MHz"] {
        let line = display.lines().find(|line| line.contains(board));
        assert!(
            line.is_some_and(|line| line.contains(" about ")),
            "{display}"
        );
    }
    let [display, linear] = [&display, &linear].map(|output| output.lines().last());
    assert!(display.is_some_and(|line| line.starts_with("checksum: ")));
    assert_eq!(display, linear);
    Ok(())
}

/// Uses a scene in which decoding and the start of each line are a large part of the cost.
#[test]
fn stats_print_the_estimates_of_the_model() -> Outcome {
    let here = Directory::new("estimate")?;
    let output = here.ok(&["render", "phong_terms", "--size", "96x72", "--stats"])?;
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes/phong_terms.toml");
    let mut buffer = Box::new(scene_file::Buffer::new());
    let file = scene_file::load(&file)?;
    let work = Work::of(&file.prepare(&mut buffer)?, Size::new(96, 72));
    for board in &BOARDS[..2] {
        let title = format!("{} at", board.title);
        let predicted = board.instructions(&work) / 1e6;
        let text = format!(" {predicted:.1} M instructions");
        let line = output.lines().find(|line| line.contains(&title));
        assert!(
            line.is_some_and(|line| line.ends_with(&text)),
            "{text} is not in {output}"
        );
    }
    Ok(())
}

#[test]
fn options_replace_the_ray_limits_of_the_scene() -> Outcome {
    let here = Directory::new("options")?;
    let output = here.ok(&[
        "render",
        "whitted",
        "--size",
        "16x12",
        "--max-depth",
        "0",
        "--stats",
    ])?;
    assert!(
        output.contains("192 camera, 0 reflected, 0 transmitted"),
        "{output}"
    );
    let output = here.ok(&[
        "render",
        "whitted",
        "--size",
        "16x12",
        "--min-weight",
        "1",
        "--stats",
    ])?;
    assert!(output.contains("192 camera, "), "{output}");
    Ok(())
}
