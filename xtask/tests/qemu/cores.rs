//! Firmware without a display on all cores.

use anyhow::Result;
use embedded_graphics::prelude::*;
use whitted_sim::{render, scene_file};
use xtask::core::Core;
use xtask::qemu::{Arithmetic, Machine};
use xtask::soak::soak;
use xtask::{host, scene, scenes};

#[path = "../../../tests/rigs/motion/src/scene.rs"]
mod moving;

#[test]
fn assembly_products_are_exact() -> Result<()> {
    for core in Core::DISTINCT {
        let machine = Machine::of(core);
        let report = machine.run(&machine.rig("products").build(None)?)?;
        report.result()?;
        assert!(report.number("pairs")? > 2_000_000, "{core}: {report}");
    }
    Ok(())
}

#[test]
fn all_cores_draw_the_same_pictures() -> Result<()> {
    let large = ["whitted", "sphereflake"].map(|name| (scene(name), Size::new(320, 240)));
    let small = scenes()?.into_iter();
    let small = small.map(|scene| (scene, Size::new(80, 60)));
    for (scene, size) in small.chain(large) {
        let expected = host::checksum(&scene, size)?;
        let compiled = Arithmetic::Fixed.compile(&scene)?;
        let size = format!("{}x{}", size.width, size.height);
        for core in Core::ALL {
            let machine = Machine::of(core);
            let elf = machine.rig("headless").build(None)?;
            let report = machine.draw(&elf, &compiled, &size)?;
            let drawn = report.result()?.get("checksum")?;
            assert_eq!(drawn, expected, "{} on {core}", scene.display());
        }
    }
    Ok(())
}

/// Camera orbits use floats, in software on the M0+ and M3, in hardware on the others.
#[test]
fn all_cores_draw_the_same_animation() -> Result<()> {
    let [width, height] = moving::SIZE;
    let mut buffer = Box::new(scene_file::Buffer::new());
    let mut animation = buffer.prepare_animation(&moving::SCENE, &moving::ANIMATION)?;
    let mut expected = Vec::new();
    for time in moving::TIMES {
        let picture = render::linear(&animation.frame(time)?, Size::new(width, height));
        expected.push(format!("{:08x}", render::checksum(&picture)));
    }
    for core in Core::DISTINCT {
        let machine = Machine::of(core);
        let report = machine.run(&machine.rig("motion").build(None)?)?;
        report.result()?;
        for (frame, expected) in expected.iter().enumerate() {
            let drawn = report.get(&format!("checksum {frame}"))?;
            assert_eq!(drawn, expected, "frame {frame} on {core}");
        }
    }
    Ok(())
}

/// `cargo xtask prove soak` draws 10,000 frames.
#[test]
fn a_hundred_frames_equal_those_of_the_host() -> Result<()> {
    for core in [Core::M0, Core::M3] {
        soak(core, 100)?;
    }
    Ok(())
}
