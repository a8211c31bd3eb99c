//! Errors of the command line.

use std::fs;

use crate::directory::{Directory, Outcome};

#[test]
fn rejects_bad_input() -> Outcome {
    let here = Directory::new("bad")?;
    fs::write(here.0.join("bad.toml"), "colour = 1\n")?;
    fs::write(here.0.join("bad.scene"), [0xff, 0xfe])?;
    here.ok(&["compile", "whitted", "-o", "still.scene"])?;
    let cases: [(&[&str], &str); 38] = [
        (
            &["render", "bad.toml"],
            "error: bad.toml:1: colour: a scene has no such key\n  help: ",
        ),
        (&["check", "bad.toml"], "error: bad.toml:1: colour: "),
        (
            &["compile", "bad.toml", "-o", "x.scene"],
            "error: bad.toml:1: colour: ",
        ),
        (
            &["check", "bad.scene"],
            "error: bad.scene: not a compiled scene\n  help: ",
        ),
        (
            &["check", "witted"],
            "error: witted: no such scene\n  help: did you mean `scenes/whitted.toml`?\n",
        ),
        (
            &["check", "nothing/like.it"],
            "error: nothing/like.it: no such scene\n  help: the scenes in scenes/ are ",
        ),
        (&["compare", "a.png", "b.png"], "error: a.png: "),
        (
            &["render", "whitted", "--size", "320"],
            "error: invalid value '320' for '--size <WxH>': write width and",
        ),
        (
            &["render", "whitted", "--size", "0x9"],
            "error: invalid value '0x9' for '--size <WxH>': width and",
        ),
        (
            &["render", "whitted", "--max-depth", "33"],
            "error: invalid value '33' for '--max-depth <N>': 33 is not in 0..=32\n",
        ),
        (
            &["render", "whitted", "--size", "640x480", "--scale", "16"],
            "error: --scale 16: the picture would have 10240x7680 pixels; the longest side is 8192\n",
        ),
        (
            &["render", "whitted", "--max-depth", "-1"],
            "error: invalid value '-1' for '--max-depth <N>': -1 is not in 0..=32\n",
        ),
        (
            &["render", "whitted", "--scale", "-2"],
            "error: invalid value '-2' for '--scale <N>': -2 is not in 1..=16\n",
        ),
        (
            &["animate", "whitted", "-o", "x.gif", "--frames", "-3"],
            "error: invalid value '-3' for '--frames <N>': -3 is not in 1..=65535\n",
        ),
        (
            &["render", "whitted", "--size", "-1x2"],
            "error: invalid value '-1x2' for '--size <WxH>': write width and",
        ),
        (
            &["render", "whitted", "--size", "4097x1"],
            "error: invalid value '4097x1' for '--size <WxH>': width and height must be from 1 to 4096\n",
        ),
        (
            &["render", "whitted", "--min-weight", "2"],
            "error: --min-weight 2: must be from 0 to 1\n",
        ),
        (
            &["render", "whitted", "--min-weight", "-1"],
            "error: --min-weight -1: must be from 0 to 1\n",
        ),
        (
            &["render", "whitted", "--size", "2x2", "-o", "no/x.png"],
            "error: no/x.png: cannot be written: ",
        ),
        (
            &["render", "whitted", "--size", "2x2", "-o", "x.jpg"],
            "error: x.jpg: not the name of a PNG\n  help: write FILE.png\n",
        ),
        (
            &["render", "whitted", "--size", "2x2", "-o", "x"],
            "error: x: not the name of a PNG\n",
        ),
        (
            &["compile", "whitted", "-o", "x.png"],
            "error: x.png: not the name of a compiled scene\n  help: write FILE.scene or FILE.bin\n",
        ),
        (
            &["render", "whitted", "--display", "ssd1360"],
            "error: invalid value 'ssd1360' for '--display <NAME>': did you mean `ssd1306`?",
        ),
        (
            &["render", "whitted", "--display", "ssd1306", "--size", "9x9"],
            "error: the argument '--display <NAME>' cannot be used with '--size <WxH>'",
        ),
        (
            &["explain", "whitted", "320", "0"],
            "error: pixel 320 0: outside the picture of 320x240\n  help: x must be from 0 to 319, y",
        ),
        (
            &["explain", "whitted", "-1", "0"],
            "error: invalid value '-1' for '<X>': ",
        ),
        (
            &["gallery", "-o", "x", "whitted", "scenes/whitted.toml"],
            "error: scenes/whitted.toml: the name `whitted.png` is already taken\n  help: ",
        ),
        (
            &["gallery", "-o", "bad.toml/x", "whitted"],
            "error: bad.toml/x: cannot be created: ",
        ),
        (
            &["animate", "whitted", "-o", "x.mp4"],
            "error: x.mp4: unknown animation format\n  help: write FILE.gif, FILE.apng, or DIR/",
        ),
        (
            &["animate", "whitted", "-o", "no/x.gif"],
            "error: no/x.gif: cannot be written: ",
        ),
        (
            &["animate", "whitted", "-o", "x.gif", "--fps", "60"],
            "error: x.gif: a GIF has at most 50 frames per second\n  help: use --fps 50 or ",
        ),
        (
            &["animate", "whitted", "-o", "x.png", "--frames", "9000"],
            "error: x.png: a frame of an APNG lasts at least 1 ms\n  help: use a smaller ",
        ),
        (
            &["animate", "whitted", "-o", "x.gif", "--container", "apng"],
            "error: x.gif: `--container` differs from the file name\n  help: ",
        ),
        (
            &["animate", "whitted", "-o", "x.gif", "--fps", "0"],
            "error: invalid value '0' for '--fps <N>': 0 is not in 1..=100\n",
        ),
        (
            &["animate", "bad.scene", "-o", "x.gif"],
            "error: bad.scene: not a compiled scene\n  help: ",
        ),
        (
            &["animate", "still.scene", "-o", "x.gif"],
            "error: still.scene: this compiled scene has no animation\n  help: ",
        ),
        (
            &["animate", "whitted", "-o", "x.gif", "--frames", "20000"],
            "error: the animation would have 20000 frames; the limit is 10000\n  help: ",
        ),
        (&["rendr"], "error: unrecognized subcommand 'rendr'\n"),
    ];
    for (args, expected) in cases {
        let message = here.error(args)?;
        assert!(message.starts_with(expected), "{args:?}: {message}");
    }
    Ok(())
}

#[cfg(not(feature = "window"))]
#[test]
fn view_needs_the_feature_window() -> Outcome {
    let here = Directory::new("view")?;
    // Without CARGO, the program cannot start a build with the feature.
    let output = here.command(&["view"]).env_remove("CARGO").output()?;
    assert_eq!(output.status.code(), Some(2));
    let message = String::from_utf8(output.stderr)?;
    assert!(
        message.contains("libsdl2-dev") && message.contains("--features window"),
        "{message}"
    );
    Ok(())
}
