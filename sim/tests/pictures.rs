//! PNG files, and the comparison of pictures.

use std::error::Error;
use std::fs::File;
use std::io::BufWriter;
use std::path::{Path, PathBuf};

use whitted::Color;
use whitted_sim::compare::{SizesDiffer, compare};
use whitted_sim::picture::Picture;
use whitted_sim::png16;

fn picture(width: u32, height: u32, grays: &[u16]) -> Picture {
    let pixels = grays
        .iter()
        .map(|gray| Color::new(*gray, *gray, *gray))
        .collect();
    Picture {
        width,
        height,
        pixels,
    }
}

fn file(name: &str) -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join(name)
}

/// Writes a 2x1 PNG in a format that the library only reads.
fn write(
    path: &Path,
    (color, depth): (png::ColorType, png::BitDepth),
    samples: &[u8],
) -> Result<(), Box<dyn Error>> {
    let mut encoder = png::Encoder::new(BufWriter::new(File::create(path)?), 2, 1);
    encoder.set_color(color);
    encoder.set_depth(depth);
    Ok(encoder.write_header()?.write_image_data(samples)?)
}

#[test]
fn reads_back_what_it_writes() -> Result<(), Box<dyn Error>> {
    let path = file("round_trip.png");
    let pixels = vec![Color::new(0, 1, 65535), Color::new(256, 255, 32768)];
    let picture = Picture {
        width: 1,
        height: 2,
        pixels,
    };
    png16::write(&path, &picture)?;
    assert_eq!(png16::read(&path)?, picture);
    Ok(())
}

#[test]
fn writes_a_gamma_of_one() -> Result<(), Box<dyn Error>> {
    let path = file("gamma.png");
    png16::write(&path, &picture(1, 1, &[0]))?;
    let reader = png::Decoder::new(std::io::BufReader::new(File::open(path)?)).read_info()?;
    let gamma = reader.info().gama_chunk.map(png::ScaledFloat::into_value);
    assert_eq!(gamma, Some(1.0));
    Ok(())
}

#[test]
fn reads_gray_and_8_bit_files() -> Result<(), Box<dyn Error>> {
    use png::{BitDepth, ColorType};
    let path = file("forms.png");
    let grays = picture(2, 1, &[0x1111, 0xffff]);
    let forms: [(_, &[u8]); 5] = [
        ((ColorType::Grayscale, BitDepth::Eight), &[0x11, 0xff]),
        ((ColorType::Grayscale, BitDepth::Four), &[0x1f]),
        (
            (ColorType::Grayscale, BitDepth::Sixteen),
            &[0x11, 0x11, 0xff, 0xff],
        ),
        (
            (ColorType::Rgb, BitDepth::Eight),
            &[0x11, 0x11, 0x11, 0xff, 0xff, 0xff],
        ),
        (
            (ColorType::GrayscaleAlpha, BitDepth::Eight),
            &[0x11, 0, 0xff, 7],
        ),
    ];
    for (form, samples) in forms {
        write(&path, form, samples)?;
        assert_eq!(png16::read(&path)?, grays, "{form:?}");
    }
    Ok(())
}

#[test]
fn errors_name_the_file() -> Result<(), Box<dyn Error>> {
    let path = file("text.png");
    std::fs::write(&path, "text")?;
    for path in [path, file("missing.png")] {
        let error = png16::read(&path).err().ok_or("an error")?.to_string();
        assert!(
            error.starts_with(&format!("{}: ", path.display())),
            "{error}"
        );
    }
    Ok(())
}

#[test]
fn equal_pictures_have_infinite_psnr() -> Result<(), Box<dyn Error>> {
    let comparison = compare(&picture(2, 1, &[0, 9]), &picture(2, 1, &[0, 9]))?;
    assert_eq!((comparison.psnr, comparison.within), (f64::INFINITY, 1.0));
    Ok(())
}

#[test]
fn black_and_white_have_a_psnr_of_zero() -> Result<(), Box<dyn Error>> {
    let comparison = compare(&picture(1, 1, &[0]), &picture(1, 1, &[65535]))?;
    assert_eq!((comparison.psnr, comparison.within), (0.0, 0.0));
    Ok(())
}

#[test]
fn one_8_bit_step_counts_as_within() -> Result<(), Box<dyn Error>> {
    let comparison = compare(&picture(2, 1, &[0, 0]), &picture(2, 1, &[257, 258]))?;
    assert_eq!(comparison.within, 0.5);
    // The mean squared error is 1, plus a small part from the second pixel's extra 1/257.
    assert!((comparison.psnr - 48.114).abs() < 0.001, "{comparison}");
    assert_eq!(
        comparison.to_string(),
        "PSNR 48.11 dB, 50.000% of pixels within 1/255"
    );
    Ok(())
}

#[test]
fn one_differing_channel_makes_the_pixel_differ() -> Result<(), Box<dyn Error>> {
    let mut other = picture(1, 1, &[0]);
    other.pixels[0].g = 300;
    assert_eq!(compare(&picture(1, 1, &[0]), &other)?.within, 0.0);
    Ok(())
}

#[test]
fn rejects_pictures_of_different_sizes() {
    let result = compare(&picture(2, 1, &[0, 0]), &picture(1, 2, &[0, 0]));
    assert_eq!(result, Err(SizesDiffer([(2, 1), (1, 2)])));
}
