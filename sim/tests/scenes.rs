//! The scenes in scenes/ and tests/scenes/.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::*;
use whitted::Renderer;
use whitted_sim::scene_file::{self, Buffer};

fn project() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

#[test]
fn every_scene_loads_and_prepares() -> Result<(), Box<dyn Error>> {
    for folder in ["scenes", "tests/scenes"] {
        let mut count = 0;
        for entry in fs::read_dir(project().join(folder))? {
            let file = scene_file::load(entry?.path())?;
            file.prepare(&mut Box::new(Buffer::new()))?;
            assert!(file.title.is_some(), "{file:?}");
            count += 1;
        }
        assert!(count >= 27, "{count} scenes in {folder}");
    }
    Ok(())
}

/// Tone of a picture on an sRGB monitor.
#[derive(Debug)]
struct Tone {
    /// Mean luma (ITU-R BT.709), from 0 to 1.
    luma: f64,
    /// Share of pixels with a channel at its greatest level, from 0 to 1.
    clipped: f64,
}

/// Renders a scene as `cargo sim render` does, and measures its tone.
fn tone(path: &Path) -> Result<Tone, Box<dyn Error>> {
    const SIZE: Size = Size::new(320, 240);
    let file = scene_file::load(path)?;
    let mut buffer = Box::new(Buffer::new());
    let scene = file.prepare(&mut buffer)?;
    let mut renderer = Renderer::new(&scene, SIZE);
    let mut line = [Rgb888::BLACK; SIZE.width as usize];
    let (mut luma, mut clipped) = (0.0, 0.0);
    for y in 0..SIZE.height {
        renderer.render_line(y, &mut line);
        for pixel in line {
            let [r, g, b] = [pixel.r(), pixel.g(), pixel.b()].map(f64::from);
            luma += (0.2126 * r + 0.7152 * g + 0.0722 * b) / 255.0;
            clipped += f64::from(u8::from([r, g, b].contains(&255.0)));
        }
    }
    let pixels = f64::from(SIZE.width * SIZE.height);
    Ok(Tone {
        luma: luma / pixels,
        clipped: clipped / pixels,
    })
}

/// A picture of the gallery is neither dark nor pale on a monitor, and keeps its highlights.
#[test]
fn pictures_of_the_gallery_are_well_exposed() -> Result<(), Box<dyn Error>> {
    let mut badly_exposed = Vec::new();
    for entry in fs::read_dir(project().join("scenes"))? {
        let path = entry?.path();
        let tone = tone(&path)?;
        println!("{}: {tone:.3?}", path.display());
        if !(0.30..=0.60).contains(&tone.luma) || tone.clipped > 0.01 {
            badly_exposed.push((path, tone));
        }
    }
    assert!(badly_exposed.is_empty(), "{badly_exposed:#?}");
    Ok(())
}

/// Returns the number of the figure that a scene's comment names, or an empty string.
fn figure(comment: &str) -> &str {
    let after = comment.strip_prefix("Figure ").unwrap_or_default();
    after.split(' ').next().unwrap_or_default()
}

#[test]
fn gallery_page_lists_each_scene_with_its_figure() -> Result<(), Box<dyn Error>> {
    let page = fs::read_to_string(project().join("docs/gallery.md"))?;
    let mut count = 0;
    for entry in fs::read_dir(project().join("scenes"))? {
        let path = entry?.path();
        let name = path.file_stem().unwrap_or_default().display();
        let comment = scene_file::load(&path)?.comment.unwrap_or_default();
        assert!(comment.ends_with('.'), "{name}: {comment}");
        let start = format!("| [`{name}`](../scenes/{name}.toml) | ");
        let row = page.lines().find(|line| line.starts_with(&start));
        let row = row.ok_or_else(|| format!("no row of {name}"))?;
        let last = row.trim_end_matches('|').rsplit('|').next();
        assert_eq!(last.map(str::trim), Some(figure(&comment)), "{row}");
        count += 1;
    }
    assert_eq!(page.matches("| [`").count(), count);
    Ok(())
}
