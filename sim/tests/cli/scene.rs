//! `sim check`, `sim compile`, `sim explain` and `sim gallery`.

use std::fs;

use whitted::Color;
use whitted_sim::png16;

use crate::directory::{Directory, Outcome};

/// A scene that never changes. The path is relative to the project root.
const WHITTED: &str = "tests/scenes/whitted.toml";

#[test]
fn compiled_scene_renders_the_same() -> Outcome {
    let here = Directory::new("compiled")?;
    here.ok(&["compile", "four_spheres", "-o", "four.scene"])?;
    assert!(
        here.ok(&["check", "four.scene"])?
            .starts_with("four.scene: ok")
    );
    let size = ["--size", "40x30", "--linear16"];
    let compiled = here.ok(&[&["render", "four.scene"][..], &size].concat())?;
    assert!(compiled.starts_with(&format!("wrote {}\n", here.0.join("four.png").display())));
    here.ok(&[&["render", "four_spheres"][..], &size].concat())?;
    let output = here.ok(&["compare", "four.png", "four_spheres.png"])?;
    assert_eq!(
        output,
        "PSNR inf, 100% of pixels within 1/255: the pictures are equal\n"
    );
    Ok(())
}

#[test]
fn checks_a_scene() -> Outcome {
    let here = Directory::new("check")?;
    let output = here.ok(&["check", WHITTED])?;
    assert!(
        output.starts_with("tests/scenes/whitted.toml: ok, 3 objects, 1 light, 4 materials\n"),
        "{output}"
    );
    Ok(())
}

#[test]
fn explains_a_pixel() -> Outcome {
    let here = Directory::new("explain")?;
    let depth = ["--size", "128x96", "--max-depth", "1"];
    let output = here.ok(&[&["explain", WHITTED, "60", "48"][..], &depth].concat())?;
    let expected = r#"C object 1, sphere "glass": weight 1.0000, local 0.0000
├─ R object 0, plane "red" or "yellow": weight 0.0800, local (0.6258, 0.4693, 0.0498)
│  └─ S light 0: visible
└─ T object 1, sphere "glass" from inside: weight 0.9300, local 0.0000
color: (0.0501, 0.0375, 0.0040)
8 bit: (13, 10, 1)
rays: 4: 1 camera, 1 reflected, 1 transmitted, 1 shadow
"#;
    assert_eq!(output, expected);
    here.ok(&["compile", WHITTED, "-o", "whitted.scene"])?;
    let output = here.ok(&[&["explain", "whitted.scene", "60", "48"][..], &depth].concat())?;
    // A compiled scene has no names.
    let named = [", plane \"red\" or \"yellow\"", ", sphere \"glass\""];
    let unnamed = named
        .iter()
        .fold(expected.to_owned(), |text, name| text.replace(name, ""));
    assert_eq!(output, unnamed);
    Ok(())
}

#[test]
fn gallery_has_pictures_page_and_sheet() -> Outcome {
    let here = Directory::new("gallery")?;
    let camera = "camera = { eye = [0, 0, 1], look_at = [0, 0, 0], fovy_deg = 33 }\n";
    let comment = "# Figure 3 of a book: one color & no object.\n";
    let red = format!("{comment}title = \"R < G\"\nbackground = [1, 0, 0]\n{camera}");
    let green = format!("background = [0, 1, 0]\n{camera}");
    fs::write(here.0.join("red.toml"), red)?;
    fs::write(here.0.join("green.toml"), green)?;
    let scenes = ["red.toml", "green.toml"];
    let output =
        here.ok(&[&["gallery", "-o", "out/all", "--size", "8x6"][..], &scenes].concat())?;
    let out = here.0.join("out/all");
    let files = ["red.png", "green.png", "contact-sheet.png", "index.html"];
    let wrote = files.map(|file| format!("wrote {}\n", out.join(file).display()));
    assert_eq!(output, wrote.concat());
    // The picture equals that of `sim render`.
    here.ok(&["render", "red.toml", "--size", "8x6"])?;
    assert_eq!(
        fs::read(out.join("red.png"))?,
        fs::read(here.0.join("red.png"))?
    );

    let sheet = png16::read(out.join("contact-sheet.png"))?;
    assert_eq!((sheet.width, sheet.height), (2 * 128 + 3 * 8, 96 + 2 * 8));
    let at = |x: usize, y: usize| sheet.pixels[y * sheet.width as usize + x];
    let (red, green) = (Color::new(0xffff, 0, 0), Color::new(0, 0xffff, 0));
    assert_eq!(
        [at(8, 8), at(135, 103), at(144, 8), at(271, 103)],
        [red, red, green, green]
    );
    let between = [
        at(7, 8),
        at(136, 8),
        at(143, 8),
        at(272, 8),
        at(8, 7),
        at(8, 104),
    ];
    assert_eq!(between, [Color::new(0x2020, 0x2020, 0x2020); 6]);

    let page = fs::read_to_string(out.join("index.html"))?;
    let caption = "<figcaption><strong>R &lt; G</strong>
    <p>One color &amp; no object.</p>
    <small>Figure 3 of a book</small>
    <small>8x6, 48 rays, scene <code>red.toml</code></small>
    <small><code>cargo sim render red.toml</code></small></figcaption>";
    assert!(page.contains(caption), "{page}");
    // A scene without a title is labeled with its name.
    assert!(page.contains("<figcaption><strong>green</strong>\n"));
    assert!(page.find("red.png") < page.find("green.png"));
    Ok(())
}
